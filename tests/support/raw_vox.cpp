#include "tests/support/raw_vox.h"

#include <cstring>
#include <functional>
#include <map>
#include <set>
#include <sstream>

namespace voxprite::test {

namespace {

using Dictionary = std::map<std::string, std::string>;

struct Cursor {
    const Bytes& file;
    std::size_t at;

    int number() {
        std::int32_t value = 0;
        std::memcpy(&value, &file.at(at + 3) - 3, 4);
        at += 4;
        return value;
    }
    std::string text() {
        const auto length = static_cast<std::size_t>(number());
        const auto* first = reinterpret_cast<const char*>(file.data()) + at;
        at += length;
        return {first, length};
    }
    Dictionary dictionary() {
        Dictionary result;
        for (int pairs = number(); pairs > 0; --pairs) {
            const std::string key = text();
            result[key] = text();
        }
        return result;
    }
};

struct Node {
    std::string kind;
    std::vector<int> links;  // nodes, or the models of a shape
    Dictionary attributes;
    Dictionary frame;  // the first
    int layer = -1;
};

// Twice the coordinates, so that the centre of a cell is whole.
using Point = std::array<int, 3>;
using Map = std::function<Point(Point)>;

Map placedBy(const Dictionary& frame, const Map& outer) {
    const int byte = frame.contains("_r") ? std::stoi(frame.at("_r")) : 4;
    Point move{};
    if (frame.contains("_t")) {
        std::istringstream words(frame.at("_t"));
        words >> move[0] >> move[1] >> move[2];
    }
    const int x = byte & 3;
    const int y = (byte >> 2) & 3;
    const std::array<int, 3> columns{x, y, 3 - x - y};
    return [=](Point p) {
        Point q;
        for (std::size_t row = 0; row < 3; ++row) {
            const int turned = p[static_cast<std::size_t>(columns[row])];
            q[row] = (((byte >> (4 + row)) & 1) ? -turned : turned) + 2 * move[row];
        }
        return outer(q);
    };
}

}  // namespace

std::uint64_t packed(int x, int y, int z) {
    constexpr int kMost = 1 << 20;
    const auto bits = [](int value) { return static_cast<std::uint64_t>(value + kMost); };
    return (bits(x) << 42) | (bits(y) << 21) | bits(z);
}

std::optional<RawVox> readRawVox(const Bytes& file) {
    if (file.size() < 20 || std::memcmp(file.data(), "VOX ", 4) != 0) return std::nullopt;
    RawVox raw;
    std::map<int, Node> nodes;
    std::set<int> hiddenLayers;
    for (Cursor chunk{file, 20}; chunk.at < file.size();) {
        const std::string id(reinterpret_cast<const char*>(file.data()) + chunk.at, 4);
        chunk.at += 4;
        const auto content = static_cast<std::size_t>(chunk.number());
        const auto children = static_cast<std::size_t>(chunk.number());
        Cursor in{file, chunk.at};
        chunk.at += content + children;
        if (id == "TDCZ") return std::nullopt;
        if (id == "SIZE") {
            RawModel& model = raw.models.emplace_back();
            std::size_t cells = 1;
            for (int& edge : model.size) {
                edge = in.number();
                cells *= static_cast<std::size_t>(edge);
            }
            model.cells.resize(cells);
        } else if (id == "XYZI") {
            for (int left = in.number(); left > 0; --left, in.at += 4) {
                const std::uint8_t* v = &file.at(in.at);
                raw.models.back().at(v[0], v[1], v[2]) = v[3];
            }
        } else if (id == "RGBA") {
            for (std::size_t i = 0; i + 4 <= content; i += 4) {
                std::memcpy(raw.colours.emplace_back().data(), &file.at(in.at + i), 4);
            }
        } else if (id == "LAYR") {
            const int layer = in.number();
            const Dictionary attributes = in.dictionary();
            if (attributes.contains("_hidden") && attributes.at("_hidden") == "1") {
                hiddenLayers.insert(layer);
            }
        } else if (id == "nTRN" || id == "nGRP" || id == "nSHP") {
            Node& node = nodes[in.number()];
            node.kind = id;
            node.attributes = in.dictionary();
            if (id == "nTRN") {
                node.links = {in.number()};
                in.number();
                node.layer = in.number();
                if (in.number() > 0) node.frame = in.dictionary();
            } else {
                for (int left = in.number(); left > 0; --left) {
                    node.links.push_back(in.number());
                    if (id == "nSHP") in.dictionary();
                }
            }
        }
    }
    raw.hasSceneGraph = !nodes.empty();

    const std::function<void(int, const Map&)> place = [&](int id, const Map& outer) {
        const Node& node = nodes.at(id);
        if (node.kind == "nTRN") {
            const bool hidden =
                node.attributes.contains("_hidden") && node.attributes.at("_hidden") == "1";
            if (!hidden && !hiddenLayers.contains(node.layer)) {
                place(node.links[0], placedBy(node.frame, outer));
            }
        } else if (node.kind == "nGRP") {
            for (const int child : node.links) place(child, outer);
        } else {
            RawModel& model = raw.models.at(static_cast<std::size_t>(node.links.at(0)));
            const auto& [sx, sy, sz] = model.size;
            for (int x = 0; x < sx; ++x) {
                for (int y = 0; y < sy; ++y) {
                    for (int z = 0; z < sz; ++z) {
                        const std::uint8_t colour = model.at(x, y, z);
                        if (colour == 0) continue;
                        const Point cell = outer(
                            {2 * (x - sx / 2) + 1, 2 * (y - sy / 2) + 1, 2 * (z - sz / 2) + 1});
                        raw.placed[packed((cell[0] - 1) / 2, (cell[1] - 1) / 2,
                                          (cell[2] - 1) / 2)] = colour;
                    }
                }
            }
        }
    };
    if (raw.hasSceneGraph) place(0, [](Point p) { return p; });
    return raw;
}

}  // namespace voxprite::test
