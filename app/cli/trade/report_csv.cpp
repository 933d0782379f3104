#include <array>
#include <cmath>
#include <cstdio>

#include "app/cli/trade/report.h"

namespace voxprite::trade {
namespace {

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + '"';
}

std::string cell(double value) {
    if (!std::isfinite(value)) return "";
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.9g", value);
    return text.data();
}
std::string cell(const std::optional<double>& value) {
    return value ? cell(*value) : "";
}

std::string cells(const PictureErrors& e) {
    std::string row;
    for (const std::string& text :
         {cell(e.flip), cell(e.flipWorst), cell(e.mismatch), cell(e.voxels), cell(e.silhouette),
          cell(e.iou), cell(e.boundaryIou), cell(e.outlineKept), cell(e.outlineTrue), cell(e.psnr),
          cell(e.ssim)})
        row += ',' + text;
    return row;
}

constexpr std::array<const char*, 11> kErrorColumns{
    "flip",         "flip_worst",   "mismatch",     "voxels", "silhouette", "iou",
    "boundary_iou", "outline_kept", "outline_true", "psnr",   "ssim"};

void addRows(const ModelReport& model, const Curve& curve, const char* series, std::string& out) {
    for (const Point& point : curve.points) {
        const Setting& s = point.setting;
        for (const AtSize& at : point.bySize) {
            out += quoted(curve.model) + ',' + series + ',' + nameOf(point.axis) + ',' +
                   quoted(point.name) + ',' + cell(s.sigma) + ',' + cell(s.viewStepDegrees) + ',' +
                   cell(at.sizePx) + ',' + cell(at.sigmaInForce) + ',' + cell(at.screenPxPerPx) +
                   cells(at.sprite) + cells(at.perspective);
            if (at.numbers)
                out += ',' + std::to_string(at.numbers->samples) + ',' + cell(at.numbers->voxels) +
                       ',' + cell(at.numbers->silhouette);
            else
                out += ",,,";
            out += ',' + cell(at.time.changedADegree) + ',' + cell(at.time.flipsADegree) + ',' +
                   cell(at.time.crawlADegree);
            if (at.costs) {
                const Costs& c = *at.costs;
                out += ',' + cell(c.milliseconds.median) + ',' + cell(c.milliseconds.least) + ',' +
                       cell(c.milliseconds.most) + ',' + std::to_string(c.milliseconds.runs) + ',' +
                       cell(c.rays) + ',' + cell(c.casts) + ',' + cell(c.bytes) + ',' +
                       cell(c.prepareMilliseconds) + ',' + c.backend;
            } else {
                out += ",,,,,,,,,";
            }
            out += ',' + quoted(model.file) + '\n';
        }
    }
}

}  // namespace

std::string csvOf(const TradeReport& report) {
    std::string out =
        "model,series,axis,setting,sigma,view_step_degrees,size_px,sigma_in_force,"
        "screen_px_a_virtual_px";
    for (const char* yardstick : {"sprite_", "perspective_"})
        for (const char* column : kErrorColumns) out += std::string(",") + yardstick + column;
    out +=
        ",numbers_samples,numbers_voxels,numbers_silhouette,changed_a_degree,flips_a_degree,crawl_"
        "a_degree,ms,ms_least,ms_most,ms_"
        "runs,"
        "rays,casts,bytes,prepare_ms,backend,file\n";
    for (const ModelReport& model : report.models) {
        addRows(model, model.curve, "game", out);
        if (model.light) addRows(model, *model.light, "light", out);
    }
    return out;
}

}  // namespace voxprite::trade
