// From every format to every other: what comes back differs from what was written only in what
// lossesOf() said before.

#include <gtest/gtest.h>

#include <functional>
#include <sstream>

#include "core/io/formats.h"
#include "core/model/entity_voxels.h"
#include "tests/support/must.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::must;

// The voxels that are seen, as text that does not depend on how they are kept.
std::string seen(const Document& document, int frame, glm::ivec3 origin,
                 const std::function<std::string(std::uint8_t)>& worth) {
    std::ostringstream text;
    for (const auto& [at, value] : test::mapOf(flatten(document, frame))) {
        const auto& [x, y, z] = at;
        text << x - origin.x << ',' << y - origin.y << ',' << z - origin.z << ':' << worth(value)
             << ' ';
    }
    return text.str();
}

std::string rgb(const Palette& palette, std::uint8_t index) {
    const Rgba8 c = palette.colours[index];
    return std::to_string(c.x) + "/" + std::to_string(c.y) + "/" + std::to_string(c.z);
}

std::string nothing(std::uint8_t /*index*/) {
    return {};
}

glm::ivec3 cornerOf(const Document& document) {
    const IBox bounds = frameBounds(document, 0);
    return bounds.empty() ? glm::ivec3(0) : bounds.min;
}

std::string text(const Properties& properties) {
    std::string all;
    for (const auto& [key, value] : properties) all += key + "=" + value + ";";
    return all;
}

// An aspect of a document, and how a loss of it reads (one of the words).
struct Aspect {
    const char* name;
    std::string (*of)(const Document& document);
    std::vector<const char*> words;
};

const std::vector<Aspect>& aspects() {
    static const std::vector<Aspect> list{
        {"shape", [](const Document& d) { return seen(d, 0, cornerOf(d), nothing); }, {}},
        {"place",
         [](const Document& d) { return seen(d, 0, glm::ivec3(0), nothing); },
         {"is moved by"}},
        {"colours",
         [](const Document& d) {
             return seen(d, 0, cornerOf(d), [&](std::uint8_t v) { return rgb(d.palette, v); });
         },
         {"indices alone"}},
        {"opacity",
         [](const Document& d) {
             return seen(d, 0, cornerOf(d),
                         [&](std::uint8_t v) { return std::to_string(d.palette.colours[v].w); });
         },
         {"indices alone", "transparency"}},
        {"indices",
         [](const Document& d) {
             return seen(d, 0, cornerOf(d), [](std::uint8_t v) { return std::to_string(v); });
         },
         {"the indices"}},
        {"palette",
         [](const Document& d) {
             std::string colours;
             for (int k = 1; k < 256; ++k) {
                 colours += rgb(d.palette, static_cast<std::uint8_t>(k)) + " ";
             }
             return colours;
         },
         {"indices alone", "unused colours"}},
        {"colour names",
         [](const Document& d) {
             std::string names;
             for (const std::string& name : d.palette.names) names += name + ";";
             return names;
         },
         {"names"}},
        {"materials",
         [](const Document& d) {
             std::string all;
             for (const Properties& material : d.palette.materials) all += text(material) + "|";
             return all;
         },
         {"materials"}},
        {"order",
         [](const Document& d) {
             std::string all;
             for (const std::uint8_t k : d.palette.displayOrder) all += std::to_string(k) + " ";
             return all;
         },
         {"order of display", "indices alone"}},
        {"ramps",
         [](const Document& d) { return std::to_string(d.palette.ramps.size()); },
         {"ramps"}},
        {"variants",
         [](const Document& d) { return std::to_string(d.palette.variants.size()); },
         {"variants"}},
        {"frames",
         [](const Document& d) {
             std::string all;
             for (int frame = 0; frame < frameCount(d); ++frame) {
                 all += seen(d, frame, cornerOf(d), nothing) + "\n";
             }
             return all;
         },
         {"frames"}},
        {"objects",
         [](const Document& d) {
             std::string all;
             for (const Instance& i : instancesOf(d, 0)) {
                 all += text(d.nodes[static_cast<std::size_t>(i.node)].attributes) + "object;";
             }
             return all;
         },
         {"merged", "attributes"}},
        {"object names",
         [](const Document& d) {
             std::string all;
             for (const Instance& i : instancesOf(d, 0)) {
                 // "Object" is what those are called that have no name.
                 const std::string& name = d.nodes[static_cast<std::size_t>(i.node)].name;
                 all += (name == "Object" ? "" : name) + ";";
             }
             return all;
         },
         {"merged", "names of objects", "cut off"}},
        {"hidden objects",
         [](const Document& d) {
             return std::to_string(instancesOf(d, 0, true).size() - instancesOf(d, 0).size());
         },
         {"hidden objects"}},
        {"groups",
         [](const Document& d) {
             std::string all;
             for (const SceneNode& node : d.nodes) {
                 if (node.isGroup()) all += std::to_string(node.children.size()) + " ";
             }
             return all;
         },
         {"groups", "merged", "hidden"}},
        {"layers", [](const Document& d) { return std::to_string(d.layers.size()); }, {"layers"}},
        {"locks",
         [](const Document& d) {
             std::string all;
             for (const SceneNode& node : d.nodes) all += node.locked ? "locked " : "";
             return all;
         },
         {"locks"}},
        {"turns",
         [](const Document& d) {
             std::string all;
             for (const SceneNode& node : d.nodes) {
                 const int turn = node.placements[0].placement.rotation.toVoxByte();
                 if (turn != SignedPermutation{}.toVoxByte()) all += std::to_string(turn) + " ";
             }
             return all;
         },
         {"turns", "merged", "stands as it is seen"}},
        {"clips",
         [](const Document& d) {
             std::string all;
             // Frames without clips get one of this name in .svo.
             for (const Clip& clip : d.clips) all += clip.name == "all" ? "" : clip.name + ";";
             return all;
         },
         {"clips"}},
        {"sockets",
         [](const Document& d) {
             std::string all;
             for (const Socket& socket : d.sockets) {
                 const glm::dvec3 at = socket.positions[0].positionVoxels;
                 all += socket.name + std::to_string(at.x + at.y + at.z) + ";";
             }
             return all;
         },
         {"sockets"}},
        {"entity name", [](const Document& d) { return d.entity.name; }, {"its name"}},
        {"anchor",
         [](const Document& d) {
             const glm::dvec3 at = d.entity.anchorVoxels.value_or(glm::dvec3(0.0));
             return std::to_string(at.x) + " " + std::to_string(at.y) + " " + std::to_string(at.z);
         },
         {"anchor"}},
        {"rotation",
         [](const Document& d) {
             return std::to_string(d.entity.yawDegrees + d.entity.pitchDegrees +
                                   d.entity.rollDegrees);
         },
         {"rotation"}},
        {"scale", [](const Document& d) { return std::to_string(d.entity.scale); }, {"scale"}},
        {"authored",
         [](const Document& d) {
             return std::to_string(d.authored.voxelSizeMetres) + " " +
                    std::to_string(d.authored.sigma);
         },
         {"VoxelSize"}},
        {"cameras",
         [](const Document& d) {
             return std::to_string(d.cameras.size() + d.renderSettings.size());
         },
         {"cameras"}},
    };
    return list;
}

bool isSaid(const Aspect& aspect, const std::vector<std::string>& losses) {
    for (const std::string& loss : losses) {
        for (const char* word : aspect.words) {
            if (loss.find(word) != std::string::npos) return true;
        }
    }
    return false;
}

Document through(const std::filesystem::path& path, const Document& document) {
    GameProfile profile;
    profile.voxelSizeMetres = document.authored.voxelSizeMetres;
    profile.sigma = document.authored.sigma;
    const Status saved = saveDocument(path, document, profile);
    if (!saved) throw std::runtime_error(saved.error().describe());
    return must(loadDocument(path)).document;
}

std::vector<Document> starts() {
    Document busy = test::busyDocument();
    busy.palette.variants = {{"Red", {{1, Rgba8(255, 0, 0, 255)}}}};
    busy.palette.ramps = {{"stone", {1, 2, 3}}};
    busy.cameras = {{4, {{"_mode", "pers"}}}};
    busy.nodes[3].attributes = {{"_other", "1"}};
    Document plain = test::documentOf(test::figure());
    Document walk = test::animationOf({test::figure(), test::asymmetric(), test::figure()});
    Document far = test::documentOf(test::asymmetric());
    far.nodes[1].placements[0].placement.translation = {-300, 40, 7};
    far.nodes[1].name = "far";
    return {busy, plain, walk, far, Document::withEmptyModel()};
}

// Formats that keep voxels: meshes give surfaces back, and are tested where they live.
bool keepsVoxels(const FormatInfo& info) {
    return info.reads() && info.writes() && info.keepsVoxels;
}

std::vector<std::string> aspectsOf(const Document& document) {
    std::vector<std::string> all;
    for (const Aspect& aspect : aspects()) all.push_back(aspect.of(document));
    return all;
}

TEST(FormatPairs, DifferOnlyInWhatWasSaidBefore) {
    const test::TemporaryFolder folder;
    int pairs = 0, equal = 0;
    for (const Document& start : starts()) {
        for (const FormatInfo& from : formats()) {
            if (!keepsVoxels(from)) continue;
            const Document before = through(folder / (std::string("a") + from.ending), start);
            const std::vector<std::string> was = aspectsOf(before);
            for (const FormatInfo& to : formats()) {
                if (!keepsVoxels(to)) continue;
                ++pairs;
                const std::vector<std::string> losses = lossesOf(before, to.format);
                const Document after = through(folder / (std::string("b") + to.ending), before);
                const std::vector<std::string> is = aspectsOf(after);
                for (std::size_t k = 0; k < is.size(); ++k) {
                    if (was[k] == is[k]) continue;
                    EXPECT_TRUE(isSaid(aspects()[k], losses))
                        << from.name << " -> " << to.name << ": " << aspects()[k].name << " was\n"
                        << was[k].substr(0, 300) << "\nand is\n"
                        << is[k].substr(0, 300);
                }
                // Nothing said, nothing changed: not even what the aspects do not look at.
                if (from.format == to.format && from.holds.colours != ColoursHeld::none &&
                    losses.empty()) {
                    EXPECT_EQ(before, after) << from.name;
                    ++equal;
                }
            }
        }
    }
    EXPECT_GE(pairs, 5 * 25);
    EXPECT_GT(equal, 10);
}

}  // namespace
}  // namespace voxprite
