// voxprite compare A.png B.png: how different two pictures are.
#include <cstdio>

#include "app/cli/command.h"
#include "core/io/png.h"
#include "core/measure/compare.h"

namespace voxprite::cli {
namespace {

struct CompareOptions {
    std::string a, b;
};

std::string describe(const ImageComparison& c) {
    char text[512];
    std::snprintf(text, sizeof text,
                  "pixels          %llu\n"
                  "mismatched      %llu (%.4f %%)\n"
                  "silhouette XOR  %llu, IoU %.6f, boundary IoU %.6f\n"
                  "FLIP mean       %.6f, inside %.6f\n"
                  "PSNR            %s\n"
                  "SSIM            %.6f\n",
                  static_cast<unsigned long long>(c.pixels),
                  static_cast<unsigned long long>(c.mismatched), 100.0 * c.mismatchRate,
                  static_cast<unsigned long long>(c.silhouetteXor), c.iou, c.boundaryIou,
                  c.flipMean, c.flipInside,
                  c.psnr ? (std::to_string(*c.psnr) + " dB").c_str() : "equal", c.ssim);
    return text;
}

Result<Report> compare(const CompareOptions& options) {
    const Result<Image> a = readPngFile(options.a);
    if (!a) return Failure(a.error());
    const Result<Image> b = readPngFile(options.b);
    if (!b) return Failure(b.error());
    const Result<ImageComparison> c = inFile(compareImages(*a, *b), options.b);
    if (!c) return Failure(c.error());
    Report report;
    report.json = {{"pixels", c->pixels},
                   {"mismatched", c->mismatched},
                   {"mismatch_rate", c->mismatchRate},
                   {"silhouette_xor", c->silhouetteXor},
                   {"iou", c->iou},
                   {"boundary_iou", c->boundaryIou},
                   {"flip_mean", c->flipMean},
                   {"flip_inside", c->flipInside},
                   {"psnr", c->psnr ? Json(*c->psnr) : Json(nullptr)},
                   {"ssim", c->ssim}};
    report.text = describe(*c);
    return report;
}

}  // namespace

void addCompare(CLI::App& app, Command& command) {
    CLI::App& sub = *app.add_subcommand("compare", "Measure how different two pictures are");
    auto options = std::make_shared<CompareOptions>();
    sub.add_option("A", options->a, "A PNG")->required();
    sub.add_option("B", options->b, "Another PNG of the same size")->required();
    addJsonFlag(sub, command);
    runs(sub, command, options, compare);
}

}  // namespace voxprite::cli
