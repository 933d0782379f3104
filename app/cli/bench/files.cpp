// Reading, converting and exporting files, in memory (the disk is not measured).
#include "app/cli/bench/bench.h"
#include "core/base/file.h"
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
        return {};
    }

  private:
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
    return figures;
}

}  // namespace voxprite::bench
