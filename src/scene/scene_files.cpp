#include "scene/scene_files.h"

#include <string>

#include "base/error.h"
#include "files/terrain/grid_hash.h"
#include "scene/initial_bed.h"
#include "scene/input_maps.h"
#include "scene/read.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

void add_grid(const fs::path& grid, std::vector<fs::path>& files) {
    files.push_back(grid);
    try {
        for (const GridPart& part : grid_parts(grid)) files.push_back(part.file);
    } catch (const InputError&) {
        // whoever reads the grid says what is wrong with it
    }
}

void add_bed(const Scene& scene, std::vector<fs::path>& files) {
    if (scene.bed.file.empty()) return;
    add_grid(bed_path(scene), files);
}

/// The files that a run of the scene reads.
void add_inputs(const Scene& scene, std::vector<fs::path>& files) {
    add_bed(scene, files);
    Scene named = scene;
    for (const InputKey& key : input_keys(named)) {
        if (key.path != "bed.file") add_grid(input_path(scene, key), files);
    }
}

void add_other_scene(const Scene& scene, const std::string& other, std::vector<fs::path>& files) {
    if (other.empty()) return;
    files.push_back(scene.directory / other);
    try {
        add_inputs(read_scene(files.back()), files);
    } catch (const InputError&) {
        // whoever draws the figure says what is wrong with it
    }
}

}  // namespace

std::vector<fs::path> scene_files(const Scene& scene) {
    std::vector<fs::path> files;
    add_inputs(scene, files);
    if (!scene.figure.words.empty()) files.push_back(scene.directory / scene.figure.words);
    for (const PanelSettings& panel : scene.figure.panels) {
        add_other_scene(scene, panel.scene, files);
        add_other_scene(scene, panel.chart.minus_scene, files);
        for (const CurveSettings& curve : panel.curves) {
            add_other_scene(scene, curve.scene, files);
            if (!curve.file.empty()) files.push_back(scene.directory / curve.file);
        }
    }
    return files;
}

}  // namespace fumon
