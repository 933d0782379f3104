#include <algorithm>
#include <cmath>

#include "app/cli/trade/report.h"
#include "core/io/json_text.h"
#include "core/io/profile_json.h"

namespace voxprite::trade {
namespace {

const char* nameOf(Representation kind) {
    switch (kind) {
        case Representation::sprite:
            return "sprite";
        case Representation::snapshot:
            return "snapshot";
        case Representation::clusters:
            return "clusters";
        case Representation::coarse:
            return "coarse";
    }
    return "";
}

Json known(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

Json jsonOf(const PictureErrors& e) {
    return {{"mismatch", e.mismatch},
            {"voxels", known(e.voxels)},
            {"silhouette", known(e.silhouette)},
            {"iou", e.iou},
            {"boundary_iou", e.boundaryIou},
            {"outline_kept", known(e.outlineKept)},
            {"outline_true", known(e.outlineTrue)},
            {"flip", e.flip},
            {"flip_worst", e.flipWorst},
            {"psnr", known(e.psnr)},
            {"ssim", e.ssim}};
}

Json jsonOf(const Spread& s) {
    return {{"least", s.least}, {"median", s.median}, {"most", s.most}, {"runs", s.runs}};
}

Json jsonOf(const AtSize& at) {
    Json json{{"size_px", at.sizePx},
              {"sigma_in_force", known(at.sigmaInForce)},
              {"screen_px_a_virtual_px", known(at.screenPxPerPx)},
              {"sprite", jsonOf(at.sprite)},
              {"perspective", jsonOf(at.perspective)},
              {"numbers", nullptr},
              {"time",
               {{"changed_a_degree", at.time.changedADegree},
                {"flips_a_degree", at.time.flipsADegree},
                {"crawl_a_degree", at.time.crawlADegree}}},
              {"costs", nullptr}};
    if (at.numbers)
        json["numbers"] = {{"samples", at.numbers->samples},
                           {"voxels", at.numbers->voxels},
                           {"silhouette", at.numbers->silhouette}};
    if (at.costs)
        json["costs"] = {{"ms", jsonOf(at.costs->milliseconds)},
                         {"rays", at.costs->rays},
                         {"casts", at.costs->casts},
                         {"bytes", at.costs->bytes},
                         {"prepare_ms", at.costs->prepareMilliseconds},
                         {"backend", at.costs->backend}};
    return json;
}

void addPoints(const Curve& curve, const char* series, Json& out) {
    const std::vector<std::size_t> bySprite = paretoFront(curve, Yardstick::sprite);
    const std::vector<std::size_t> byPerspective = paretoFront(curve, Yardstick::perspective);
    const auto on = [](const std::vector<std::size_t>& front, std::size_t k) {
        return std::find(front.begin(), front.end(), k) != front.end();
    };
    for (std::size_t k = 0; k < curve.points.size(); ++k) {
        const Point& point = curve.points[k];
        Json sizes = Json::array();
        for (const AtSize& at : point.bySize) sizes.push_back(jsonOf(at));
        out.push_back(
            {{"series", series},
             {"axis", nameOf(point.axis)},
             {"name", point.name},
             {"setting", jsonOf(point.setting)},
             {"flip",
              {{"sprite", point.error(Yardstick::sprite)},
               {"perspective", point.error(Yardstick::perspective)}}},
             {"ms", known(point.milliseconds())},
             {"rays", known(point.rays())},
             {"front", {{"sprite", on(bySprite, k)}, {"perspective", on(byPerspective, k)}}},
             {"sizes", std::move(sizes)}});
    }
}

Json jsonOf(const ModelReport& model) {
    Json skipped = Json::array();
    for (const Skipped& one : model.skipped)
        skipped.push_back({{"name", one.name}, {"reason", one.reason}});
    Json points = Json::array();
    addPoints(model.curve, "game", points);
    if (model.light) addPoints(*model.light, "light", points);
    return {{"name", jsonTextFromBytes(model.curve.model)},
            {"file", jsonTextFromBytes(model.file)},
            {"size", {model.size.x, model.size.y, model.size.z}},
            {"voxels", model.voxels},
            {"octree_bytes", model.octreeBytes},
            {"settings", model.settings},
            {"profile", Json::parse(writeProfile(model.curve.profile))},
            {"plan",
             {{"seed", model.plan.seed},
              {"views", model.plan.views},
              {"sizes_px", model.plan.sizesPx},
              {"frames", model.plan.frames},
              {"degrees_a_frame", model.plan.degreesAFrame},
              {"recorded_frames", model.plan.recordedWay.size()},
              {"flip_pixels_a_degree", model.plan.flipPixelsPerDegree}}},
            {"skipped", std::move(skipped)},
            {"points", std::move(points)}};
}

Json jsonOf(const Growth& growth) {
    Json samples = Json::array();
    for (const Growth::Sample& sample : growth.samples)
        samples.push_back({{"size", sample.size},
                           {"ms", jsonOf(sample.milliseconds)},
                           {"rays", sample.rays},
                           {"bytes", sample.bytes}});
    return {{"key", growth.key},
            {"title", growth.title},
            {"unit", growth.unit},
            {"what", growth.what},
            {"not_run", growth.notRun},
            {"samples", std::move(samples)},
            {"exponents",
             {{"ms", known(exponentOf(growth, millisecondsOf))},
              {"rays", known(exponentOf(growth, raysOf))},
              {"bytes", known(exponentOf(growth, bytesOf))}}}};
}

}  // namespace

Json jsonOf(const Setting& s) {
    return {{"sigma", s.sigma},
            {"mode", voxprite::nameOf(s.mode)},
            {"view_step_degrees", s.viewStepDegrees},
            {"proxy", voxprite::nameOf(s.proxy)},
            {"registration", voxprite::nameOf(s.registration)},
            {"occlusion", s.occlusion},
            {"shadow", s.shadow},
            {"drawn_by", nameOf(s.drawnBy)},
            {"view_set", s.viewSet},
            {"snapshot_kind", s.snapshotKind == SnapshotKind::seed ? "seed" : "sprite"},
            {"snapshot_px", s.snapshotPx},
            {"coarse_levels", s.coarseLevels},
            {"cluster_budget_px", s.clusterBudgetPx},
            {"walk", s.walk == Walk::fp32 ? "fp32" : "lattice"}};
}

Json jsonOf(const TradeReport& report) {
    Json models = Json::array();
    for (const ModelReport& model : report.models) models.push_back(jsonOf(model));
    Json growth = Json::array();
    for (const Growth& one : report.growth) growth.push_back(jsonOf(one));
    return {{"schema", "voxprite-trade"},
            {"version", kSchemaVersion},
            {"finished", report.finished},
            {"program", {{"version", VOXPRITE_VERSION}, {"commit", report.commit}}},
            {"machine", report.machine},
            {"backend", report.backend},
            {"models", std::move(models)},
            {"growth", std::move(growth)}};
}

}  // namespace voxprite::trade
