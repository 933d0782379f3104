// Small files cut at every length and with every byte changed: an error or a document, soon.
#include <gtest/gtest.h>

#include "core/io/mesh_texture.h"
#include "core/io/mesh_writer.h"
#include "core/io/obj_reader.h"
#include "core/io/png.h"
#include "tests/core/io/mesh_shapes.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

Document smallDocument() {
    VoxelGrid voxels;
    voxels.set({0, 0, 0}, 1);
    return documentOf(std::move(voxels));
}

// What a mesh file makes, one in 32 down to its voxels at a low resolution; both ends are fine.
int outcome(Result<MeshImport> import) {
    static int number = 0;
    if (!import) {
        EXPECT_FALSE(import.error().message.empty());
        return 0;
    }
    if (number++ % 32 != 0) return 1;
    const auto loaded = voxelsOf(std::move(import->mesh), options(4, true, 1));
    if (!loaded) return 0;
    EXPECT_TRUE(validate(loaded->document));
    return 1;
}

template <class Read>
void damage(const Bytes& file, int flips, const Read& read) {
    ASSERT_EQ(read(file), 1);
    int read1 = 0, refused = 0;
    const auto count = [&](const Bytes& bytes) { ++(read(bytes) == 1 ? read1 : refused); };
    for (std::size_t length = 0; length < file.size(); ++length) {
        count(Bytes(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(length)));
    }
    for (std::size_t at = 0; at < file.size(); ++at) {
        for (int flip = 0; flip < flips; ++flip) {
            Bytes changed = file;
            changed[at] ^= static_cast<std::uint8_t>(flip == 0 ? 0xFF : 1 << (at % 8));
            count(changed);
        }
    }
    EXPECT_GT(refused, 0);
    EXPECT_GT(read1, 0);
}

TEST(MeshDamage, GlbIsReadOrRefused) {
    const GameProfile profile;
    const Document document = smallDocument();
    WriteOptions options;
    options.mesh.vertexColours = true;
    for (const WriteOptions& chosen : {WriteOptions{}, options}) {
        const Bytes file = must(writeGlb({document, profile, chosen, "x.glb", {}}));
        damage(file, 2, [](const Bytes& bytes) { return outcome(readGltf(bytes, ModelFolder())); });
    }
}

TEST(MeshDamage, ObjIsReadOrRefused) {
    const std::string text =
        "mtllib a.mtl\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nv 0 1 2e-1 1 1 1\n"
        "vt 0.5 0.5\nvn 0 0 1\nusemtl red\ng a b\no c\ns 1\nf 1/1/1 2/1/1 3/1/1 4/1/1\n"
        "f -1//-1 -2//1 -3//1\n";
    damage(Bytes(text.begin(), text.end()), 2, [](const Bytes& bytes) {
        return outcome(readObj(bytes, ModelFolder(), MeshUpAxis::y));
    });
}

TEST(MeshDamage, TexturesAreBounded) {
    Image image(3, 2, Rgba8(9, 8, 7, 255));
    const Bytes png = must(writePng(image));
    EXPECT_EQ(must(readTexture(png, 6)), image);
    EXPECT_FALSE(readTexture(png, 5));
    EXPECT_FALSE(readTexture(ByteView(png).first(20), 6));
    EXPECT_FALSE(readTexture({}, 6));
    // A JPEG head that promises 65,500 pixels an edge.
    const Bytes jpeg{0xFF, 0xD8, 0xFF, 0xC0, 0x00, 0x0B, 0x08, 0xFF, 0xDC,
                     0xFF, 0xDC, 0x01, 0x01, 0x11, 0x00, 0xFF, 0xD9};
    EXPECT_FALSE(readTexture(jpeg, kMaxTexturePixels));
    Bytes smaller = jpeg;
    smaller[7] = smaller[9] = 0x10;
    const auto refused = readTexture(smaller, kMaxTexturePixels);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("cut short"), std::string::npos);
}

}  // namespace
}  // namespace voxprite::test
