#include "core/io/vox.h"
#include "core/io/vox_file.h"

namespace voxprite {

Result<VoxImport> readVox(ByteView bytes) {
    Result<VoxFile> file = parseVox(bytes);
    if (!file) return tl::unexpected(file.error());
    Result<std::vector<SceneNode>> nodes = sceneFromVox(*file, bytes.size());
    if (!nodes) return tl::unexpected(nodes.error());

    VoxImport import;
    Document& document = import.document;
    document.palette = paletteFromVox(std::move(file->palette), file->warnings);
    document.models = std::move(file->models);
    document.nodes = std::move(*nodes);
    document.layers = std::move(file->layers);
    document.cameras = std::move(file->cameras);
    document.renderSettings = std::move(file->renderSettings);
    if (Status s = validate(document); !s) return tl::unexpected(s.error());
    import.warnings = file->warnings.release();
    return import;
}

}  // namespace voxprite
