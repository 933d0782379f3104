// Which grids of a .vdb file become voxels, and how.
#include <algorithm>
#include <cstdio>
#include <functional>
#include <set>

#include "core/io/colour_reduction.h"
#include "core/io/grid_budget.h"
#include "core/io/project_json.h"
#include "core/io/vdb.h"
#include "core/io/vdb_colours.h"
#include "core/io/vdb_file.h"

namespace voxprite {
namespace {

using vdb::Grid;
using vdb::Value;

bool isLevelSet(const Grid& grid) {
    return grid.gridClass == "level set";
}

// Calls put(box, value) for all cells of a tree, tiles as they are and leaves cell by cell, where
// pick(value, active) is not 0.
template <class Pick, class Put>
Status forEachSolid(const Grid& grid, const Pick& pick, const Put& put) {
    vdb::Visit visit;
    visit.tile = [&](glm::ivec3 origin, int edge, const Value& value, bool active) -> Status {
        const int index = pick(value, active);
        return index == 0 ? Status{} : put(IBox{origin, origin + edge}, index);
    };
    visit.leaf = [&](glm::ivec3 origin, int edge, std::span<const Value> values,
                     const std::vector<bool>& active) -> Status {
        std::size_t n = 0;
        for (int x = 0; x < edge; ++x) {
            for (int y = 0; y < edge; ++y) {
                for (int z = 0; z < edge; ++z, ++n) {
                    const int index = pick(values[n], active[n]);
                    if (index == 0) continue;
                    const glm::ivec3 at = origin + glm::ivec3(x, y, z);
                    if (Status s = put(IBox{at, at + 1}, index); !s) return s;
                }
            }
        }
        return {};
    };
    ByteReader reader = grid.tree;
    return walk(grid, reader, visit);
}

template <class Pick>
Result<VoxelGrid> voxelsOf(const Grid& grid, GridBudget& budget, const Pick& pick) {
    BudgetedGrid voxels(budget);
    const Status filled = forEachSolid(grid, pick, [&](const IBox& box, int index) -> Status {
        if (!isInVoxelRange(box.min) || !isInVoxelRange(box.max - 1)) {
            return fail("the grid \"" + grid.name + "\" reaches beyond +-" +
                        std::to_string(kMaxCoordinate) + " voxels");
        }
        const auto value = static_cast<std::uint8_t>(index);
        const bool fits = box.size().x == 1 ? voxels.set(box.min, value) : voxels.fill(box, value);
        return fits ? Status{} : Status(fail(GridBudget::refusal()));
    });
    if (!filled) return Failure(filled.error());
    return voxels.release();
}

// Goes through all voxels. Those of one value that lie in a tile of the colours are cubes of one
// colour: cube(box, colour). The others come as blocks of eight: block(origin, values), with no
// values where all are solid. Ends, and is false, where one of the two is.
template <class Cube, class Block>
bool forEachColoured(const VoxelGrid& voxels, const vdb::Colours& colours, const Cube& cube,
                     const Block& block) {
    bool go = true;
    const std::function<void(const IBox&)> split = [&](const IBox& box) {
        if (const auto colour = colours.over(box)) {
            go = cube(box, *colour);
            return;
        }
        if (box.size().x == 8) {
            go = block(box.min, nullptr);
            return;
        }
        const int part = box.size().x / 8;
        for (int n = 0; go && n < 512; ++n) {
            const glm::ivec3 at = box.min + glm::ivec3(n >> 6, n >> 3 & 7, n & 7) * part;
            split({at, at + part});
        }
    };
    voxels.forEachBlock([&](const VoxelBlock& stored) {
        if (!go) return;
        if (stored.voxels == nullptr) return split(stored.box());
        go = block(stored.origin, stored.voxels);
    });
    return go;
}

// Calls visit(v) for what is solid of a block.
template <class Visit>
bool forEachIn(glm::ivec3 origin, const std::uint8_t* values, const Visit& visit) {
    for (int n = 0; n < 512; ++n) {
        if (values != nullptr && values[n] == 0) continue;
        if (!visit(origin + glm::ivec3(n >> 6, n >> 3 & 7, n & 7))) return false;
    }
    return true;
}

class Import {
  public:
    Import(const vdb::File& file, const VdbReadOptions& options, std::uint64_t fileBytes)
        : file_(file), options_(options), budget_(fileBytes) {}

    Result<VdbImport> run() {
        if (Status s = rest(); !s) return Failure(s.error());
        std::vector<const Grid*> chosen;
        for (const Grid& grid : file_.grids) {
            if (isIndexed(grid) && isWanted(grid)) chosen.push_back(&grid);
        }
        if (!chosen.empty()) {
            for (const Grid* grid : chosen) {
                if (Status s = indexed(*grid); !s) return Failure(s.error());
            }
        } else if (Status s = shaped(); !s) {
            return Failure(s.error());
        }
        passedOver();
        if (document().models.empty()) {
            return fail("the file has no grid that could be voxels" +
                        (options_.grid.empty() ? "" : " of the name \"" + options_.grid + "\""));
        }
        if (Status s = validate(document()); !s) return Failure(s.error());
        return std::move(import_);
    }

  private:
    Document& document() { return import_.document; }
    void warn(std::string sentence) { import_.warnings.push_back(std::move(sentence)); }

    static bool isIndexed(const Grid& grid) {
        if (!grid.type || grid.isInstance) return false;
        const vdb::Kind kind = grid.type->kind;
        return kind == vdb::Kind::whole || kind == vdb::Kind::boolean || kind == vdb::Kind::mask;
    }
    bool isWanted(const Grid& grid) const {
        return options_.grid.empty() || grid.name == options_.grid;
    }

    // What voxprite noted beside the grids.
    Status rest() {
        const auto noted = file_.texts.find("voxprite");
        if (noted == file_.texts.end()) return {};
        Result<ProjectJson> project = readProjectJson(noted->second);
        if (!project) {
            return fail("the metadata \"voxprite\" is damaged: " + project.error().describe());
        }
        document().palette = std::move(project->document.palette);
        document().entity = std::move(project->document.entity);
        document().sockets = std::move(project->document.sockets);
        document().authored = project->document.authored;
        return {};
    }

    // The middle. Blocks that are moved off their own grid take up to eight times the memory, and
    // large ones of one value far more, which the budget does not know: where there are many the
    // middle is rounded.
    glm::ivec3 pivotOf(const VoxelGrid& voxels, const IBox& bounds) {
        constexpr std::uint64_t kFew = 1 << 16;
        const glm::ivec3 middle = bounds.min + bounds.size() / 2;
        movedCubes_ += voxels.cubeCount();
        if (movedCubes_ <= kFew) return middle;
        int step = 8;
        voxels.forEachBlock([&](const VoxelBlock& block) {
            if (block.voxels == nullptr) step = std::max(step, block.edgeVoxels);
        });
        return middle & -step;
    }

    void add(const Grid& grid, const VoxelGrid& voxels) {
        used_.insert(&grid);
        const IBox bounds = voxels.bounds();
        const glm::ivec3 pivot = bounds.empty() ? glm::ivec3(0) : pivotOf(voxels, bounds);
        Model model;
        model.canvas = {bounds.empty() ? glm::ivec3(0) : bounds.min - pivot,
                        bounds.empty() ? glm::ivec3(0) : bounds.max - pivot};
        voxels.forEachBlock([&](const VoxelBlock& block) {
            if (block.voxels == nullptr) {
                model.voxels.fill({block.origin - pivot, block.origin - pivot + block.edgeVoxels},
                                  block.uniformValue);
                return;
            }
            for (int n = 0; n < 512; ++n) {
                if (block.voxels[n] == 0) continue;
                const glm::ivec3 v = block.origin + glm::ivec3(n >> 6, n >> 3 & 7, n & 7);
                model.voxels.set(v - pivot, block.voxels[n]);
            }
        });
        SceneNode object;
        object.name = grid.name;
        object.parent = 0;
        object.placements[0].placement.translation = pivot;
        object.models = {{0, static_cast<int>(document().models.size())}};
        document().nodes[0].children.push_back(static_cast<int>(document().nodes.size()));
        document().nodes.push_back(std::move(object));
        document().models.push_back(std::move(model));
    }

    Status indexed(const Grid& grid) {
        std::set<double> numbers;
        const auto note = [&](const Value& value, bool active) {
            if (active && value[0] != 0.0 && numbers.size() <= 255) numbers.insert(value[0]);
            return 0;
        };
        if (Status s = forEachSolid(grid, note, [](const IBox&, int) { return Status{}; }); !s) {
            return s;
        }
        const bool arePlaces =
            numbers.empty() || (*numbers.begin() >= 1.0 && *numbers.rbegin() <= 255.0);
        if (!arePlaces && numbers.size() > 255) {
            return fail("the grid \"" + grid.name +
                        "\" has more than 255 different numbers, which no palette holds");
        }
        if (!arePlaces) {
            warn("the numbers of the grid \"" + grid.name +
                 "\" are no palette indices: numbered anew, from the least to the greatest");
        }
        const auto pick = [&](const Value& value, bool active) {
            if (!active || value[0] == 0.0) return 0;
            if (arePlaces) return static_cast<int>(value[0]);
            return static_cast<int>(std::distance(numbers.begin(), numbers.find(value[0]))) + 1;
        };
        Result<VoxelGrid> voxels = voxelsOf(grid, budget_, pick);
        if (!voxels) return Failure(voxels.error());
        add(grid, *voxels);
        return {};
    }

    const Grid* firstOf(bool (*fits)(const Grid&)) const {
        for (const Grid& grid : file_.grids) {
            if (grid.type && !grid.isInstance && isWanted(grid) && fits(grid)) return &grid;
        }
        return nullptr;
    }

    // A level set or density, with colours beside it; or colours alone.
    Status shaped() {
        const auto isReal = [](const Grid& g) { return g.type->kind == vdb::Kind::real; };
        const auto isVector = [](const Grid& g) { return g.type->kind == vdb::Kind::vector; };
        const Grid* shape = firstOf(
            [](const Grid& g) { return g.type->kind == vdb::Kind::real && g.name == "density"; });
        if (shape == nullptr) {
            shape = firstOf(
                [](const Grid& g) { return g.type->kind == vdb::Kind::real && isLevelSet(g); });
        }
        if (shape == nullptr) shape = firstOf(isReal);
        if (shape == nullptr) shape = firstOf(isVector);
        if (shape == nullptr) return {};
        return isVector(*shape) ? colourVoxels(*shape) : solidVoxels(*shape);
    }

    Status solidVoxels(const Grid& shape) {
        const bool levelSet = isLevelSet(shape);
        const double threshold = options_.threshold;
        Result<VoxelGrid> voxels = voxelsOf(shape, budget_, [&](const Value& value, bool) {
            return (levelSet ? value[0] < 0.0 : value[0] > threshold) ? 1 : 0;
        });
        if (!voxels) return Failure(voxels.error());
        char above[48];
        std::snprintf(above, sizeof(above), "above %g", threshold);
        warn("the grid \"" + shape.name + "\" is taken as a " +
             (levelSet ? std::string("level set: negative") : std::string("density: ") + above) +
             " is inside");
        const Grid* colours = coloursBeside();
        if (colours == nullptr) {
            add(shape, *voxels);
            return {};
        }
        return coloured(shape, *voxels, *colours);
    }

    Status colourVoxels(const Grid& grid) {
        Result<VoxelGrid> voxels =
            voxelsOf(grid, budget_, [](const Value&, bool active) { return active ? 1 : 0; });
        if (!voxels) return Failure(voxels.error());
        return coloured(grid, *voxels, grid);
    }

    const Grid* coloursBeside() const {
        const Grid* only = nullptr;
        int count = 0;
        for (const Grid& grid : file_.grids) {
            if (!grid.type || grid.isInstance || grid.type->kind != vdb::Kind::vector) continue;
            std::string name = grid.name;
            std::ranges::transform(name, name.begin(), [](char c) {
                return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
            });
            if (name == "cd" || name == "color" || name == "colour" || name == "diffuse") {
                return &grid;
            }
            only = &grid;
            ++count;
        }
        return count == 1 ? only : nullptr;
    }

    Status coloured(const Grid& shape, const VoxelGrid& voxels, const Grid& colours) {
        Result<vdb::Colours> field = vdb::Colours::of(colours, voxels);
        if (!field) return Failure(field.error());
        // A block of many colours is one in memory, too.
        std::uint64_t blocks = 0;
        bool fits = forEachColoured(
            voxels, *field, [](const IBox&, Rgba8) { return true; },
            [&](glm::ivec3, const std::uint8_t*) { return budget_.has(++blocks); });
        if (!fits) return fail(GridBudget::refusal());
        ColourCount count;
        forEachColoured(
            voxels, *field,
            [&](const IBox& cube, Rgba8 colour) {
                const auto edge = static_cast<std::uint64_t>(cube.size().x);
                count.add(colour, edge * edge * edge);
                return true;
            },
            [&](glm::ivec3 origin, const std::uint8_t* values) {
                return forEachIn(origin, values, [&](glm::ivec3 v) {
                    count.add(field->at(v));
                    return true;
                });
            });
        const ReducedColours reduced = reduceColours(count);
        BudgetedGrid painted(budget_);
        fits = forEachColoured(
            voxels, *field,
            [&](const IBox& cube, Rgba8 colour) {
                return painted.fill(cube, reduced.indexOf(colour));
            },
            [&](glm::ivec3 origin, const std::uint8_t* values) {
                return forEachIn(origin, values, [&](glm::ivec3 v) {
                    return painted.set(v, reduced.indexOf(field->at(v)));
                });
            });
        if (!fits) return fail(GridBudget::refusal());
        document().palette = reduced.palette;
        warn("colours are those of the grid \"" + colours.name + "\", taken as sRGB");
        if (const auto warning = reduced.warning()) warn(*warning);
        used_.insert(&colours);
        add(shape, painted.release());
        return {};
    }

    void passedOver() {
        std::string names;
        for (const Grid& grid : file_.grids) {
            if (used_.contains(&grid)) continue;
            names += (names.empty() ? "\"" : ", \"") + grid.name + "\" (" + grid.typeName + ")";
        }
        if (!names.empty()) warn("passed over: " + names);
    }

    const vdb::File& file_;
    const VdbReadOptions& options_;
    GridBudget budget_;
    VdbImport import_;
    std::uint64_t movedCubes_ = 0;
    std::set<const Grid*> used_;
};

}  // namespace

Result<VdbImport> readVdb(ByteView bytes, const VdbReadOptions& options) {
    const Result<vdb::File> file = vdb::parse(bytes);
    if (!file) return Failure(file.error());
    if (file->grids.empty()) {
        VdbImport import;
        import.document = Document::withEmptyModel();
        import.warnings.emplace_back("the file has no grid");
        return import;
    }
    return Import(*file, options, bytes.size()).run();
}

}  // namespace voxprite
