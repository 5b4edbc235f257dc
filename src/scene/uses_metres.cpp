#include "scene/uses_metres.h"

#include "models/registry.h"

namespace fumon {

bool uses_metres(const Scene& scene) {
    const ModelEntry* model = find_model(scene.model.name);
    return model != nullptr && model->home.cell_size > 0.0;
}

}  // namespace fumon
