#include "app/cli/conformance/representations.h"

#include "core/sprite/placed_entity.h"
#include "render/gl/context.h"
#include "render/measure_representations.h"

namespace voxprite::conformance {

namespace {

std::string nameOf(RepresentationChoice choice, const ViewSet& views) {
    switch (choice.kind) {
        case Representation::sprite:
            return "exact sprite";
        case Representation::snapshot:
            return "snapshot, " + std::to_string(views.count()) + " views";
        case Representation::clusters:
            return "clusters";
        case Representation::coarse:
            return "coarser by " + std::to_string(choice.levels);
    }
    return {};
}

Result<std::vector<ViewSet>> viewSets() {
    std::vector<ViewSet> sets{ViewSet()};
    for (const int edge : {8, 16}) {
        Result<ViewSet> set = ViewSet::octahedral(edge);
        if (!set) return Failure(set.error());
        sets.push_back(std::move(*set));
    }
    return sets;
}

Status measureModel(const TurningModel& model, const MeasuringPlan& plan,
                    const std::vector<ViewSet>& sets, SceneRenderer& renderer,
                    std::vector<RepresentationRow>& rows) {
    const Result<ModelLevels> built = buildModelLevels(model.octree);
    if (!built) return Failure(built.error());
    const GpuModelLevels levels(*built);
    GpuModelLevels none;  // snapshots alone
    GpuOctree octree;
    octree.upload(model.octree.view());
    const GameProfile profile;
    const PlacedEntity placed =
        placeEntity(Entity{}, IBox{glm::ivec3(0), model.octree.size}, profile);
    for (std::size_t k = 0; k < sets.size(); ++k) {
        const MeasuredModel measured{
            &octree, &model.palette, placed, k == 0 ? &levels : &none, &sets[k], 1.0};
        const Result<RepresentationTable> table =
            measureRepresentations(renderer, measured, profile, plan);
        if (!table) return Failure(table.error());
        for (const RepresentationFigures& figures : *table) {
            if (k > 0 && figures.choice.kind != Representation::snapshot) continue;
            rows.push_back({model.name, nameOf(figures.choice, sets[k]), figures});
        }
    }
    return {};
}

}  // namespace

Result<std::vector<RepresentationRow>> measureRepresentationRows(
    const std::vector<TurningModel>& models, const std::vector<double>& sizesPx, int views) {
    const Result<gl::HeadlessContext> context = gl::HeadlessContext::create();
    if (!context) return Failure(context.error());
    Result<SceneRenderer> renderer = SceneRenderer::create();
    if (!renderer) return Failure(renderer.error());
    const Result<std::vector<ViewSet>> sets = viewSets();
    if (!sets) return Failure(sets.error());
    MeasuringPlan plan;
    plan.sizesPx = sizesPx;
    plan.views = views;
    std::vector<RepresentationRow> rows;
    for (const TurningModel& model : models) {
        const Status measured = measureModel(model, plan, *sets, *renderer, rows);
        if (!measured) return Failure(measured.error());
    }
    return rows;
}

}  // namespace voxprite::conformance
