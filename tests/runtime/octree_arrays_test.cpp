// The octree arrays are those of the runtime's description (svo-format.md): a decoder written from
// it alone, sharing no code with core/svo, reads exported files and must find the document's
// voxels. It takes the arrays as a runtime does: NODE and PAYL of all models in one texture of
// 32-bit texels, tightly packed, with NodeOffset and PayloadOffset added on every look-up.
#include <gtest/gtest.h>

#include <random>

#include "core/model/entity_voxels.h"
#include "tests/core/io/svo_sections.h"
#include "tests/runtime/exported_samples.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

// Linear index i lies at x = i % width, y = i / width: nodes first, then two texels a payload.
class Texture {
  public:
    Texture(const std::vector<std::uint8_t>& nodes, const std::vector<std::uint8_t>& payloads)
        : firstPayload_(nodes.size() / 4) {
        const std::size_t count = (nodes.size() + payloads.size()) / 4;
        rows_.resize(count / kWidth + 1, std::vector<std::uint32_t>(kWidth, 0xFFFF'FFFF));
        for (std::size_t i = 0; i < count; ++i) {
            const bool node = i < firstPayload_;
            rows_[i / kWidth][i % kWidth] = test::valueAt<std::uint32_t>(
                node ? nodes : payloads, 4 * (node ? i : i - firstPayload_));
        }
    }
    [[nodiscard]] std::uint32_t node(std::size_t index) const { return texel(index); }
    [[nodiscard]] std::uint32_t payload(std::size_t index, unsigned high) const {
        return texel(firstPayload_ + 2 * index + high);
    }

  private:
    static constexpr std::size_t kWidth = 61;  // no power of two: nothing leans on one
    [[nodiscard]] std::uint32_t texel(std::size_t i) const {
        return rows_.at(i / kWidth).at(i % kWidth);
    }
    std::size_t firstPayload_;
    std::vector<std::vector<std::uint32_t>> rows_;
};

struct Descriptor {
    std::uint32_t nodeOffset, payloadOffset, maxDepth, x, y, z, nodes, payloads;
    std::int32_t origin[3];
};

// The whole cube of the root, node by node, with what the description promises of each.
class Decoder {
  public:
    Decoder(const Texture& texture, const Descriptor& model) : texture_(texture), model_(model) {
        cube(0, 0, 0, 0, 0);
    }
    VoxelGrid voxels;
    std::uint32_t nodesReached = 0;
    std::uint32_t payloadsReached = 0;

  private:
    // Returns the material of a uniform leaf, 256 of anything else.
    unsigned cube(std::uint32_t index, unsigned depth, std::uint32_t x, std::uint32_t y,
                  std::uint32_t z) {
        ++nodesReached;
        const std::uint32_t word = texture_.node(model_.nodeOffset + std::size_t{index});
        const std::uint32_t edge = 1u << (model_.maxDepth - depth);
        if ((word & 0x80000000u) != 0) {
            internal(word, depth, x, y, z);
            return 256;
        }
        if ((word & 0x40000000u) != 0) {
            EXPECT_EQ(depth, model_.maxDepth - 1) << "leaves are bricks at the deepest level";
            brick(word & 0x3FFFFFFFu, x, y, z);
            return 256;
        }
        EXPECT_EQ(word & 0xFFFFFF00u, 0u) << "other bits of a uniform leaf";
        for (std::uint32_t dz = 0; dz < edge; ++dz) {
            for (std::uint32_t dy = 0; dy < edge; ++dy) {
                for (std::uint32_t dx = 0; dx < edge; ++dx) put(x + dx, y + dy, z + dz, word);
            }
        }
        return word;
    }

    void internal(std::uint32_t word, unsigned depth, std::uint32_t x, std::uint32_t y,
                  std::uint32_t z) {
        const std::uint32_t childBase = (word << 1) >> 9;  // bits 30 ... 8
        const std::uint32_t half = 1u << (model_.maxDepth - depth - 1);
        std::uint32_t stored = 0;
        unsigned kinds[8] = {};
        for (unsigned octant = 0; octant < 8; ++octant) {
            if ((word >> octant) % 2 == 0) continue;
            const unsigned bits[3] = {octant % 2, octant / 2 % 2, octant / 4};
            kinds[octant] = cube(childBase + stored, depth + 1, x + bits[0] * half,
                                 y + bits[1] * half, z + bits[2] * half);
            EXPECT_NE(kinds[octant], 0u) << "an empty child is not stored";
            ++stored;
        }
        EXPECT_GT(stored, 0u);
        bool uniform = kinds[0] < 256;
        for (const unsigned kind : kinds) uniform = uniform && kind == kinds[0];
        EXPECT_FALSE(uniform) << "eight uniform leaves of one material are one";
    }

    void brick(std::uint32_t payload, std::uint32_t x, std::uint32_t y, std::uint32_t z) {
        ++payloadsReached;
        bool uniform = true;
        unsigned materials[8] = {};
        for (unsigned octant = 0; octant < 8; ++octant) {
            const std::uint32_t word = texture_.payload(model_.payloadOffset + std::size_t{payload},
                                                        octant / 4);  // low word first
            materials[octant] = (word >> (8 * (octant % 4))) % 256;
            uniform = uniform && materials[octant] == materials[0];
            put(x + octant % 2, y + octant / 2 % 2, z + octant / 4, materials[octant]);
        }
        EXPECT_FALSE(uniform) << "a brick of eight equal materials is a uniform leaf";
    }

    void put(std::uint32_t x, std::uint32_t y, std::uint32_t z, std::uint32_t material) {
        if (material == 0) return;
        EXPECT_TRUE(x < model_.x && y < model_.y && z < model_.z) << "solid outside the size";
        voxels.set({static_cast<int>(x) + model_.origin[0], static_cast<int>(y) + model_.origin[1],
                    static_cast<int>(z) + model_.origin[2]},
                   static_cast<std::uint8_t>(material));
    }

    const Texture& texture_;
    const Descriptor& model_;
};

// MaxDepth = ceil(log2(max(sizeX, sizeY, sizeZ))), and 1 for a single voxel.
std::uint32_t depthOf(const Descriptor& model) {
    std::uint32_t depth = 1;
    while ((1u << depth) < std::max({model.x, model.y, model.z})) ++depth;
    return depth;
}

std::vector<VoxelGrid> decoded(const Bytes& bytes) {
    std::vector<test::SvoSection> sections = test::sectionsOf(bytes);
    const auto& descriptors = test::sectionNamed(sections, "MODL").bytes;
    const Texture texture(test::sectionNamed(sections, "NODE").bytes,
                          test::sectionNamed(sections, "PAYL").bytes);
    std::vector<VoxelGrid> models;
    std::uint32_t nodes = 0, payloads = 0;
    for (std::size_t at = 0; at < descriptors.size(); at += 64) {
        Descriptor model{};
        std::uint32_t* fields[] = {
            &model.nodeOffset, &model.payloadOffset, &model.maxDepth, &model.x, &model.y,
            &model.z,          &model.nodes,         &model.payloads};
        for (std::size_t i = 0; i < 8; ++i) {
            *fields[i] = test::valueAt<std::uint32_t>(descriptors, at + 4 * i);
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
            model.origin[axis] = test::valueAt<std::int32_t>(descriptors, at + 32 + 4 * axis);
        }
        EXPECT_EQ(model.nodeOffset, nodes) << "one after the other";
        EXPECT_EQ(model.payloadOffset, payloads);
        EXPECT_EQ(model.maxDepth, depthOf(model));
        Decoder decoder(texture, model);
        EXPECT_EQ(decoder.nodesReached, model.nodes) << "nodes that nothing reaches";
        EXPECT_EQ(decoder.payloadsReached, model.payloads);
        models.push_back(std::move(decoder.voxels));
        nodes += model.nodes;
        payloads += model.payloads;
    }
    return models;
}

// Which model each frame shows, read from the file's own sections.
std::vector<std::uint32_t> framesOf(const Bytes& bytes) {
    std::vector<test::SvoSection> sections = test::sectionsOf(bytes);
    const auto& section = test::sectionNamed(sections, "FRAM").bytes;
    std::vector<std::uint32_t> frames;
    for (std::size_t at = 0; at < section.size(); at += 8) {
        frames.push_back(test::valueAt<std::uint32_t>(section, at));
    }
    return frames.empty() ? std::vector<std::uint32_t>{0} : frames;
}

TEST(OctreeArrays, AnIndependentDecoderFindsTheVoxelsOfEverySample) {
    for (const test::ExportedSample& sample : test::exportedSamples()) {
        SCOPED_TRACE(sample.name);
        const std::vector<VoxelGrid> models = decoded(sample.bytes);
        const std::vector<std::uint32_t> frames = framesOf(sample.bytes);
        ASSERT_EQ(frames.size(), static_cast<std::size_t>(frameCount(sample.document)));
        for (std::size_t frame = 0; frame < frames.size(); ++frame) {
            EXPECT_EQ(models.at(frames[frame]), flatten(sample.document, static_cast<int>(frame)))
                << "frame " << frame;
        }
    }
}

TEST(OctreeArrays, AnIndependentDecoderFindsTheVoxelsOfUnlikeModelsInOneFile) {
    std::vector<SvoFile> set;
    std::vector<VoxelGrid> expected;
    for (const test::ExportedSample& sample : test::exportedSamples()) {
        set.push_back(test::must(readSvo(sample.bytes)));
        for (VoxelGrid& model : decoded(sample.bytes)) expected.push_back(std::move(model));
    }
    EXPECT_EQ(decoded(test::must(writeSvoSet(set))), expected);
    EXPECT_EQ(decoded(test::must(writeSvoSet({set.data(), 1}))).size(), set[0].models.size());
}

TEST(OctreeArrays, AnIndependentDecoderFindsTheVoxelsOfRandomModels) {
    std::mt19937 random(7);
    const auto below = [&](int n) { return std::uniform_int_distribution<int>(0, n - 1)(random); };
    for (int round = 0; round < 60; ++round) {
        std::vector<VoxelGrid> frames(static_cast<std::size_t>(1 + below(3)));
        for (VoxelGrid& grid : frames) {
            const int extent = 1 << below(6);
            const auto point = [&] {
                return glm::ivec3(below(extent), below(extent), below(extent));
            };
            for (int i = below(4); i > 0; --i) {
                const glm::ivec3 a = point(), b = point();
                grid.fill({glm::min(a, b), glm::max(a, b) + 1},
                          static_cast<std::uint8_t>(below(3)));
            }
            for (int i = 1 + below(40); i > 0; --i) {
                grid.set(point(), static_cast<std::uint8_t>(1 + below(255)));
            }
        }
        const Document document = test::animationOf(frames);
        const Bytes bytes = test::must(writeSvo(test::must(bakeForExport(document, {}))));
        const std::vector<VoxelGrid> models = decoded(bytes);
        const std::vector<std::uint32_t> shown = framesOf(bytes);
        for (std::size_t frame = 0; frame < shown.size(); ++frame) {
            ASSERT_EQ(models.at(shown[frame]), flatten(document, static_cast<int>(frame)))
                << "round " << round << ", frame " << frame;
        }
    }
}

}  // namespace
}  // namespace voxprite
