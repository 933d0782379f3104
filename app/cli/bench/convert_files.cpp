#include "app/cli/bench/convert_files.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "app/cli/bench/programs.h"
#include "app/cli/text_table.h"
#include "core/base/file.h"
#include "core/io/vox.h"

namespace voxprite::bench {
namespace {

namespace fs = std::filesystem;

constexpr int kFullEdge = 256, kQuickEdge = 64;

// A folder of this run's own, removed with all that is in it.
class WorkFolder {
  public:
    WorkFolder()
        : path_(fs::temp_directory_path() / ("voxprite-bench-" + std::to_string(::getpid()))) {
        std::error_code error;
        fs::create_directories(path_, error);
    }
    ~WorkFolder() {
        std::error_code error;
        fs::remove_all(path_, error);
    }
    WorkFolder(const WorkFolder&) = delete;
    WorkFolder& operator=(const WorkFolder&) = delete;
    [[nodiscard]] fs::path operator/(const std::string& name) const { return path_ / name; }

  private:
    fs::path path_;
};

class Conversions {
  public:
    Conversions(const Effort& effort, Json& figures) : effort_(effort), figures_(figures) {}

    // `bytes` are those of a .vox; `made`, where there is no file of that name.
    Status run(const std::string& name, const Bytes& bytes, bool made) {
        made_ = made;
        progress(effort_, "converting " + name);
        const fs::path input = folder_ / "in.vox";
        if (Status s = writeFileAtomically(input, ByteView(bytes)); !s) return s;
        for (const std::string ending : {".glb", ".obj"}) {
            const fs::path output = folder_ / ("out" + ending);
            const std::string job = "vox to " + ending.substr(1);
            measure(name, job, "voxprite", output,
                    {ownProgram(), "convert", input.string(), "-o", output.string()});
            measure(name, job, "goxel", output,
                    {"goxel", input.string(), "--export", output.string()});
        }
        return {};
    }

  private:
    void measure(const std::string& name, const std::string& job, const std::string& program,
                 const fs::path& output, const std::vector<std::string>& arguments) {
        std::error_code error;
        fs::remove(output, error);
        std::vector<ProgramRun> runs;
        const int count = effort_.quick ? 1 : 3;
        for (int k = 0; k < count; ++k) runs.push_back(runProgram(arguments));
        // A run that fails at once is no fast one.
        const ProgramRun& best = *std::ranges::min_element(
            runs, {}, [](const ProgramRun& run) { return std::pair(!run.succeeded, run.ms); });
        Json figure{{"file", name}, {"made", made_}, {"job", job}, {"program", program}};
        if (best.started && best.succeeded && fs::exists(output, error)) {
            figure["ms"] = best.ms;
            figure["cpu_ms"] = best.cpuMs;
            figure["peak_mib"] = static_cast<double>(best.peakBytes) / (1 << 20);
        } else {
            figure["ms"] = nullptr;
            figure["reason"] = !best.started ? "not installed" : "failed (it may need a display)";
        }
        figures_.push_back(std::move(figure));
    }

    WorkFolder folder_;
    Effort effort_;
    Json& figures_;
    bool made_ = false;
};

std::string cell(double ms, double mib, int missing) {
    if (ms == 0.0) return missing > 0 ? "does not run" : "";
    std::string text = cli::textOf(ms);
    if (mib > 0.0) text += " (" + cli::textOf(mib) + ")";
    if (missing > 0) text += ", " + std::to_string(missing) + " failed";
    return text;
}

}  // namespace

Status benchConversions(const std::vector<BenchModel>& models, const Effort& effort,
                        Json& figures) {
    Conversions conversions(effort, figures);
    for (const BenchModel& model : models) {
        if (model.file.empty()) continue;
        const Result<Bytes> vox = writeVox(model.document);
        if (!vox) return Failure(vox.error());
        if (Status s = conversions.run(model.name, *vox, false); !s) return s;
    }
    const int edge = effort.quick ? kQuickEdge : kFullEdge;
    Document full = Document::withEmptyModel();
    full.models[0].voxels.fill({glm::ivec3(0), glm::ivec3(edge)}, 1);
    const Result<Bytes> vox = writeVox(full);
    if (!vox) return Failure(vox.error());
    return conversions.run("full" + std::to_string(edge), *vox, true);
}

std::string fileTable(const Json& figures) {
    struct Sum {
        double ms = 0.0, peakMib = 0.0;
        int files = 0, missing = 0;
    };
    struct Row {
        std::string files, job;
        std::map<std::string, Sum> programs;
    };
    std::vector<Row> rows;
    for (const Json& figure : figures) {
        const auto file = figure["file"].get<std::string>(), job = figure["job"].get<std::string>();
        const std::string group = figure.value("made", false) ? file : "all files";
        auto row = std::ranges::find_if(
            rows, [&](const Row& r) { return r.files == group && r.job == job; });
        if (row == rows.end()) row = rows.insert(rows.end(), Row{group, job, {}});
        Sum& sum = row->programs[figure["program"].get<std::string>()];
        ++sum.files;
        if (figure["ms"].is_null()) {
            ++sum.missing;
            continue;
        }
        sum.ms += figure["ms"].get<double>();
        sum.peakMib = std::max(sum.peakMib, figure.value("peak_mib", 0.0));
    }
    std::vector<std::vector<std::string>> cells{
        {"files", "job", "voxprite, ms (peak, MiB)", "goxel, ms (peak, MiB)"}};
    for (const Row& row : rows) {
        std::vector<std::string> line{row.files, row.job};
        for (const char* program : {"voxprite", "goxel"}) {
            const auto found = row.programs.find(program);
            const Sum sum = found == row.programs.end() ? Sum{} : found->second;
            line.push_back(cell(sum.ms, sum.peakMib, sum.missing));
            if (std::string(program) == "voxprite" && row.files == "all files") {
                line[0] = std::to_string(sum.files) + " files";
            }
        }
        cells.push_back(std::move(line));
    }
    return cli::textOf(cells, cli::TableStyle::markdown);
}

}  // namespace voxprite::bench
