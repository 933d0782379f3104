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

std::string number(double value) {
    if (!std::isfinite(value)) return "";
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.9g", value);
    return text.data();
}
std::string number(const std::optional<double>& value) {
    return value ? number(*value) : "";
}

std::string cells(const PictureErrors& e) {
    std::string row;
    for (const std::string& cell :
         {number(e.flip), number(e.flipWorst), number(e.mismatch), number(e.voxels),
          number(e.silhouette), number(e.iou), number(e.boundaryIou), number(e.outlineKept),
          number(e.outlineTrue), number(e.psnr), number(e.ssim)})
        row += ',' + cell;
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
                   quoted(point.name) + ',' + number(s.sigma) + ',' + number(s.viewStepDegrees) +
                   ',' + number(at.sizePx) + ',' + number(at.sigmaInForce) + cells(at.sprite) +
                   cells(at.perspective);
            out += ',' + (at.numbers ? number(at.numbers->voxels) : "");
            out += ',' + number(at.time.changedADegree) + ',' + number(at.time.flipsADegree) + ',' +
                   number(at.time.crawlADegree);
            if (at.costs) {
                const Costs& c = *at.costs;
                out += ',' + number(c.milliseconds.median) + ',' + number(c.milliseconds.least) +
                       ',' + number(c.milliseconds.most) + ',' +
                       std::to_string(c.milliseconds.runs) + ',' + number(c.rays) + ',' +
                       number(c.casts) + ',' + number(c.bytes) + ',' +
                       number(c.prepareMilliseconds) + ',' + c.backend;
            } else {
                out += ",,,,,,,,,";
            }
            out += ',' + quoted(model.file) + '\n';
        }
    }
}

}  // namespace

std::string csvOf(const TradeReport& report) {
    std::string out = "model,series,axis,setting,sigma,view_step_degrees,size_px,sigma_in_force";
    for (const char* yardstick : {"sprite_", "perspective_"})
        for (const char* column : kErrorColumns) out += std::string(",") + yardstick + column;
    out +=
        ",numbers_voxels,changed_a_degree,flips_a_degree,crawl_a_degree,ms,ms_least,ms_most,ms_"
        "runs,"
        "rays,casts,bytes,prepare_ms,backend,file\n";
    for (const ModelReport& model : report.models) {
        addRows(model, model.curve, "game", out);
        if (model.light) addRows(model, *model.light, "light", out);
    }
    return out;
}

}  // namespace voxprite::trade
