// representation_sheet FOLDER OUT.png: the README's picture of one model in every representation,
// near, in the middle and far away. FOLDER holds near-exact.png ... far-coarse.png as `./dev
// pictures` renders them; smaller pictures are shown magnified, pixel by pixel.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <glm/common.hpp>
#include <glm/ext/vector_double3.hpp>
#include <glm/ext/vector_uint3_sized.hpp>
#include <string>

#include "app/plot/lettering.h"
#include "core/io/png.h"
#include "core/measure/compare.h"

namespace voxprite::sheet {
namespace {

using plot::Lettering;

constexpr int kCellPx = 384;
constexpr int kGapPx = 16;
constexpr int kMarginPx = 32;
constexpr int kHeadPx = 104;    // above the cells
constexpr int kCaptionPx = 34;  // below each row
constexpr int kRowLabelPx = 140;
constexpr Rgba8 kBackground{24, 27, 33, 255};
constexpr Rgba8 kText{236, 239, 244, 255};
constexpr Rgba8 kTextDim{150, 158, 170, 255};

struct Label {
    const char* file;
    const char* title;
    const char* note;
};
constexpr std::array<Label, 4> kColumns{{
    {"exact", "Exact sprite", "a ray a virtual pixel"},
    {"snapshot", "Snapshot", "the nearest of 144 views, 4.7° off"},
    {"clusters", "Clusters", "a mesh, off by a screen pixel at most"},
    {"coarse", "Coarse octree", "cells of 2 voxels"},
}};
constexpr std::array<Label, 3> kRows{{
    {"near", "Near", "16 m away"},
    {"middle", "Middle", "65 m away"},
    {"far", "Far", "260 m away"},
}};

// Sky over ground, as the sprite view has them, with soft corners.
Rgba8 cellColour(int x, int y) {
    const auto mix = [](glm::dvec3 a, glm::dvec3 b, double share) { return a + (b - a) * share; };
    constexpr double kHorizon = 0.60;
    const double height = (y + 0.5) / kCellPx;
    const glm::dvec3 sky = mix({118, 150, 178}, {188, 206, 216}, std::min(height / kHorizon, 1.0));
    const glm::dvec3 ground =
        mix({132, 146, 116}, {98, 116, 88}, std::max(height - kHorizon, 0.0) / (1.0 - kHorizon));
    const double ramp = std::clamp((height - kHorizon) * 30.0 + 0.5, 0.0, 1.0);
    constexpr double kCornerPx = 12.0;
    const double half = kCellPx * 0.5;
    const double dx = std::max(std::abs(x + 0.5 - half) - (half - kCornerPx), 0.0);
    const double dy = std::max(std::abs(y + 0.5 - half) - (half - kCornerPx), 0.0);
    const double inside = std::clamp(kCornerPx - std::hypot(dx, dy) + 0.5, 0.0, 1.0);
    const glm::dvec3 back(kBackground.x, kBackground.y, kBackground.z);
    const glm::dvec3 colour = glm::round(mix(back, mix(sky, ground, ramp), inside));
    return {glm::u8vec3(colour), 255};
}

// The picture over the cell at (left, top); each of its pixels is `scale` wide.
void drawCell(Image& sheet, int left, int top, const Image& picture) {
    const int scale = kCellPx / picture.width;
    for (int y = 0; y < kCellPx; ++y) {
        for (int x = 0; x < kCellPx; ++x) {
            Rgba8& pixel = sheet.at(left + x, top + y);
            pixel = cellColour(x, y);
            const Rgba8 over = picture.at(x / scale, y / scale);
            const auto blend = [&](int below, int above) {
                return static_cast<std::uint8_t>((below * (255 - over.w) + above * over.w + 127) /
                                                 255);
            };
            pixel = {blend(pixel.x, over.x), blend(pixel.y, over.y), blend(pixel.z, over.z), 255};
        }
    }
}

std::string differenceText(const Image& exact, const Image& picture) {
    const Result<double> flip = flipInside(exact, picture);
    if (!flip) return flip.error().describe();
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), "FLIP %.3f from the exact sprite", *flip);
    return text.data();
}

Status drawRow(Image& sheet, const std::filesystem::path& folder, std::size_t row,
               const Lettering& regular, const Lettering& bold) {
    const Label& label = kRows[row];
    const int top = kMarginPx + kHeadPx + static_cast<int>(row) * (kCellPx + kCaptionPx + kGapPx);
    bold.draw(sheet, kMarginPx, top + 30, 22, kText, label.title);
    regular.draw(sheet, kMarginPx, top + 54, 15, kTextDim, label.note);
    Image exact;
    for (std::size_t column = 0; column < kColumns.size(); ++column) {
        const Result<Image> picture =
            readPngFile(folder / (std::string(label.file) + "-" + kColumns[column].file + ".png"));
        if (!picture) return Failure(picture.error());
        if (picture->width != picture->height || kCellPx % picture->width != 0) {
            return fail("the pictures' edges must divide " + std::to_string(kCellPx));
        }
        const int magnified = kCellPx / picture->width;
        if (column == 0) {
            exact = *picture;
            regular.draw(sheet, kMarginPx, top + 76, 15, kTextDim,
                         magnified == 1 ? "as on the screen"
                                        : "magnified " + std::to_string(magnified) + "×");
        }
        const int left = kMarginPx + kRowLabelPx + static_cast<int>(column) * (kCellPx + kGapPx);
        drawCell(sheet, left, top, *picture);
        regular.draw(sheet, left + 4, top + kCellPx + 22, 15, kTextDim,
                     column == 0 ? "the yardstick" : differenceText(exact, *picture));
    }
    return {};
}

Status draw(const std::filesystem::path& folder, const std::filesystem::path& output) {
    const auto columns = static_cast<int>(kColumns.size());
    const auto rows = static_cast<int>(kRows.size());
    Image sheet(2 * kMarginPx + kRowLabelPx + columns * kCellPx + (columns - 1) * kGapPx,
                2 * kMarginPx + kHeadPx + rows * (kCellPx + kCaptionPx) + (rows - 1) * kGapPx,
                kBackground);
    const Lettering regular = Lettering::regular();
    const Lettering bold = Lettering::bold();
    for (std::size_t column = 0; column < kColumns.size(); ++column) {
        const int left =
            kMarginPx + kRowLabelPx + static_cast<int>(column) * (kCellPx + kGapPx) + 4;
        bold.draw(sheet, left, kMarginPx + 44, 26, kText, kColumns[column].title);
        regular.draw(sheet, left, kMarginPx + 74, 16, kTextDim, kColumns[column].note);
    }
    for (std::size_t row = 0; row < kRows.size(); ++row) {
        if (Status drawn = drawRow(sheet, folder, row, regular, bold); !drawn) return drawn;
    }
    return writePngFile(output, sheet);
}

}  // namespace
}  // namespace voxprite::sheet

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "representation_sheet FOLDER OUT.png\n");
        return 2;
    }
    const voxprite::Status drawn = voxprite::sheet::draw(argv[1], argv[2]);
    if (!drawn) std::fprintf(stderr, "%s\n", drawn.error().describe().c_str());
    return drawn ? 0 : 1;
}
