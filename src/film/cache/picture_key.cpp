#include "film/cache/picture_key.h"

#include <bit>
#include <cstddef>
#include <glm/glm.hpp>
#include <string_view>
#include <vector>

#include "render/view/camera.h"
#include "run/build_identity.h"
#include "scene/write.h"

namespace fumon {

namespace {

/// SHA-256 of values of many kinds, one after the other.
class KeyHash {
  public:
    void add(double value) { hash_.add_little_endian(std::bit_cast<std::uint64_t>(value)); }
    void add(std::int64_t value) { hash_.add_little_endian(static_cast<std::uint64_t>(value)); }
    void add(int value) { add(std::int64_t{value}); }
    void add(bool value) { add(std::int64_t{value ? 1 : 0}); }
    void add(std::string_view text) {
        add(static_cast<std::int64_t>(text.size()));
        hash_.add(text.data(), text.size());
    }
    void add(const char* text) { add(std::string_view(text)); }
    void add(const Sha256& other) { hash_.add(other.data(), other.size()); }
    template <class Number>
    void add(const std::vector<Number>& numbers) {
        add(static_cast<std::int64_t>(numbers.size()));
        hash_.add(numbers.data(), numbers.size() * sizeof(Number));
    }
    template <class Number>
    void add(const Field<Number>& field) {
        add(field.nx());
        add(field.ny());
        hash_.add(field.data(), field.size() * sizeof(Number));
    }
    void add(const SnapshotField& field) {
        add(field.name);
        add(field.unit);
        add(field.values);
    }
    void add(const glm::dvec2& vector) {
        add(vector.x);
        add(vector.y);
    }
    void add(const glm::dvec3& vector) {
        add(vector.x);
        add(vector.y);
        add(vector.z);
    }
    void add(const Camera& camera) {
        add(camera.perspective);
        for (const glm::dvec3& vector : {camera.right, camera.up, camera.forward, camera.eye})
            add(vector);
        add(camera.half);
        for (const double number : {camera.focus, camera.near_depth, camera.far_depth,
                                    camera.focal_length, camera.lens.radius, camera.lens.focus})
            add(number);
        add(camera.lens.point);
        add(camera.lens.aside);
    }
    void add(const SnapshotSection& section) {
        add(section.dx);
        add(section.dz);
        for (const SnapshotField& field : section.fields) add(field);
        for (const SectionCurve& curve : section.curves) {
            add(curve.name);
            add(curve.values);
        }
        for (const GrainPath& path : section.paths) {
            add(path.launch_angle);
            add(path.x);
            add(path.z);
        }
    }
    Sha256 finish() { return hash_.finish(); }

  private:
    Sha256Stream hash_;
};

}  // namespace

Sha256 snapshot_hash(const Snapshot& snapshot) {
    KeyHash hash;
    hash.add(snapshot.step);
    hash.add(snapshot.time);
    hash.add(snapshot.time_unit);
    hash.add(snapshot.bed);
    hash.add(snapshot.nodata);
    hash.add(snapshot.scale.dx);
    hash.add(snapshot.scale.dy);
    hash.add(snapshot.scale.height_unit);
    hash.add(snapshot.scale.in_metres);
    hash.add(snapshot.highest_expected);
    hash.add(snapshot.periodic);
    hash.add(static_cast<std::int64_t>(snapshot.fields.size()));
    for (const SnapshotField& field : snapshot.fields) hash.add(field);
    hash.add(static_cast<std::int64_t>(snapshot.numbers.size()));
    for (const SnapshotNumber& number : snapshot.numbers) {
        hash.add(number.name);
        hash.add(number.value);
    }
    if (snapshot.section) hash.add(*snapshot.section);
    hash.add(static_cast<int>(snapshot.landform));
    for (const SnapshotWind& wind : snapshot.winds) {
        hash.add(wind.x);
        hash.add(wind.y);
        hash.add(wind.drift);
    }
    hash.add(snapshot.grass_height);
    hash.add(snapshot.shrub_height);
    return hash.finish();
}

Sha256 renderer_key(const Scene& scene, const Snapshot& first, const RenderLimits& limits,
                    const std::string& environment) {
    KeyHash hash;
    hash.add(this_build().sources);
    hash.add(this_build().tools);
    hash.add(environment);
    hash.add(limits.tile_samples);
    hash.add(limits.draft);
    hash.add(limits.one_picture);
    hash.add(limits.pixels_alike);
    Scene drawn = scene;
    drawn.title.clear();
    drawn.view.overlays.clear();
    drawn.view.layers.clear();
    drawn.output = {};
    drawn.frames = {};
    drawn.sweep = {};
    drawn.figure = {};
    hash.add(to_toml(drawn));
    if (const Drape* laid = scene.view.laid()) {
        hash.add(laid->width);
        hash.add(laid->height);
        hash.add(laid->texels);
        hash.add(laid->strength_counts);
    }
    hash.add(snapshot_hash(first));
    return hash.finish();
}

Sha256 picture_key(const Sha256& renderer, const Sha256& snapshot, const FramePose& pose,
                   const Sha256& reference) {
    KeyHash hash;
    hash.add(renderer);
    hash.add(snapshot);
    hash.add(pose.camera);
    hash.add(pose.sun.azimuth);
    hash.add(pose.sun.elevation);
    hash.add(pose.exposure);
    hash.add(pose.share);
    hash.add(pose.reference != nullptr);
    if (pose.reference) hash.add(reference);
    hash.add(pose.frame.has_value());
    hash.add(pose.frame.value_or(0));
    hash.add(pose.metered.has_value());
    if (pose.metered) hash.add(*pose.metered);
    return hash.finish();
}

}  // namespace fumon
