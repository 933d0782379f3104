// Reading, converting and exporting files: in memory (the disk is not measured), and whole
// conversions beside Goxel's.
#include <algorithm>

#include "app/cli/bench/bench.h"
#include "app/cli/bench/convert_files.h"
#include "core/base/file.h"
#include "core/io/gltf_reader.h"
#include "core/io/mesh_voxels.h"
#include "core/io/mesh_writer.h"
#include "core/io/project_file.h"
#include "core/io/svo_file.h"
#include "core/io/vox.h"

namespace voxprite::bench {
namespace {

class FileBench {
  public:
    FileBench(const BenchModel& model, const Effort& effort, Json& out)
        : model_(model), effort_(effort), out_(out) {}

    Status run() {
        const Document& document = model_.document;
        const Result<Bytes> vox = writeVox(document);
        if (!vox) return Failure(vox.error());
        const Result<Bytes> project = writeProject(document);
        if (!project) return Failure(project.error());
        const Result<SvoFile> baked = bakeForExport(document, profile_);
        if (!baked) return Failure(baked.error());
        const Result<Bytes> svo = writeSvo(*baked);
        if (!svo) return Failure(svo.error());

        measure("read_vox", [&] { static_cast<void>(readVox(*vox)); });
        measure("write_vox", [&] { static_cast<void>(writeVox(document)); });
        measure("read_voxprite", [&] { static_cast<void>(readProject(*project)); });
        measure("write_voxprite", [&] { static_cast<void>(writeProject(document)); });
        measure("read_svo", [&] { static_cast<void>(readSvo(*svo)); });
        measure("export_svo", [&] { exportVerified(); });
        const Result<Bytes> glb = meshBytes();
        if (!glb) return Failure(glb.error());
        measure("write_glb", [&] { static_cast<void>(meshBytes()); });
        measure("read_glb", [&] { voxelise(*glb); });
        return {};
    }

  private:
    [[nodiscard]] Result<Bytes> meshBytes() const {
        return writeGlb({model_.document, profile_, {}, "model.glb", {}});
    }

    // At the model's own resolution, filled.
    void voxelise(const Bytes& glb) const {
        Result<MeshImport> import = readGltf(glb, ModelFolder());
        if (!import) return;
        const glm::ivec3 size = model_.voxels.bounds().size();
        MeshReadOptions options;
        options.resolution = std::min(std::max({size.x, size.y, size.z}), kMaxMeshResolution);
        options.solid = true;
        static_cast<void>(voxelsOf(std::move(import->mesh), options));
    }

    void measure(const char* job, const std::function<void()>& run) {
        out_.push_back({{"file", model_.name},
                        {"job", job},
                        {"program", "voxprite"},
                        {"ms", medianMs(effort_, run)}});
    }

    // Bake, write, read back, compare every voxel: what `voxprite export` does.
    void exportVerified() {
        const Result<SvoFile> baked = bakeForExport(model_.document, profile_);
        const Result<Bytes> bytes = writeSvo(*baked);
        static_cast<void>(verifyExport(*bytes, model_.document));
    }

    const BenchModel& model_;
    Effort effort_;
    Json& out_;
    GameProfile profile_;
};

}  // namespace

Result<Json> benchFiles(const std::vector<BenchModel>& models, const Effort& effort) {
    Json figures = Json::array();
    for (const BenchModel& model : models) {
        if (model.file.empty()) continue;
        Status status = FileBench(model, effort, figures).run();
        if (!status) return Failure(inFile(std::move(status), model.file.string()).error());
    }
    if (Status s = benchConversions(models, effort, figures); !s) return Failure(s.error());
    return figures;
}

}  // namespace voxprite::bench
