#include "core/io/holds.h"

#include <algorithm>
#include <set>
#include <utility>

#include "core/model/entity_voxels.h"

namespace voxprite {
namespace {

class Losses {
  public:
    Losses(const Holds& holds, const Document& document, const std::string& ending)
        : holds_(holds), document_(document), ending_(ending) {}

    std::vector<std::string> run() {
        colours();
        scene();
        count(!holds_.frames, static_cast<std::size_t>(frameCount(document_)) - 1, "frames");
        count(!holds_.clips, document_.clips.size(), "clips");
        count(!holds_.sockets, document_.sockets.size(), "sockets");
        entity();
        coordinates();
        return std::move(losses_);
    }

  private:
    void say(const std::string& sentence) { losses_.push_back(ending_ + " " + sentence); }

    void count(bool lost, std::size_t number, const std::string& what) {
        if (lost && number > 0) say("has no " + what + ": " + std::to_string(number) + " left out");
    }

    // "<beginning>; left out: a, b and c", of those that are there.
    void list(const std::string& beginning,
              const std::vector<std::pair<bool, std::string>>& parts) {
        std::vector<std::string> lost;
        for (const auto& [isThere, name] : parts) {
            if (isThere) lost.push_back(name);
        }
        if (lost.empty()) return;
        std::string text;
        for (std::size_t k = 0; k < lost.size(); ++k) {
            if (k > 0) text += k + 1 == lost.size() ? " and " : ", ";
            text += lost[k];
        }
        say(beginning + "; left out: " + text);
    }

    void colours() {
        const Palette& palette = document_.palette;
        const bool names =
            std::ranges::any_of(palette.names, [](const std::string& n) { return !n.empty(); });
        const bool materials =
            std::ranges::any_of(palette.materials, [](const Properties& m) { return !m.empty(); });
        const bool order = palette.displayOrder != Palette::identityOrder();
        switch (holds_.colours) {
            case ColoursHeld::none:
                say("holds palette indices alone: colours, names and materials are left out");
                break;
            case ColoursHeld::byValue:
                list("holds colours voxel by voxel",
                     {{true, "the indices and unused colours of the palette"},
                      {names, "names"},
                      {materials, "materials"},
                      {order, "the order of display"}});
                break;
            case ColoursHeld::palette:
                list("has no words for all of a palette",
                     {{names && !holds_.colourNames, "names of colours"},
                      {materials && !holds_.materials, "materials"},
                      {order && !holds_.displayOrder, "the palette's order of display"}});
        }
        if (holds_.colours != ColoursHeld::none && !holds_.alpha) {
            const std::size_t translucent = translucentColours();
            if (translucent > 0) {
                say("has no transparency: " + std::to_string(translucent) +
                    (translucent == 1 ? " colour becomes opaque" : " colours become opaque"));
            }
        }
        variants();
        if (!holds_.ramps) count(true, palette.ramps.size(), "colour ramps");
    }

    [[nodiscard]] std::size_t translucentColours() const {
        std::set<std::uint8_t> translucent;
        for (const Model& model : document_.models) {
            model.voxels.forEachBlock([&](const VoxelBlock& block) {
                const auto look = [&](std::uint8_t index) {
                    if (index != 0 && document_.palette.colours[index].w != 255) {
                        translucent.insert(index);
                    }
                };
                if (block.voxels == nullptr) return look(block.uniformValue);
                std::for_each(block.voxels, block.voxels + 512, look);
            });
        }
        return translucent.size();
    }

    void variants() {
        if (holds_.variants || document_.palette.variants.empty()) return;
        std::string names;
        for (const PaletteVariant& variant : document_.palette.variants) {
            names += (names.empty() ? "" : ", ") + variant.name;
        }
        say("holds one palette: the variants are left out (" + names + ")");
    }

    void scene() {
        if (holds_.scene == SceneHeld::all) return;
        const std::vector<Instance> seen = instancesOf(document_, 0);
        if (holds_.scene == SceneHeld::merged && seen.size() > 1) {
            say("holds one model: " + std::to_string(seen.size()) + " objects are merged into it");
        }
        count(true, instancesOf(document_, 0, true).size() - seen.size(), "hidden objects");
        count(true, modelsThatNoObjectShows(), "models that no object shows");
        nodes();
        count(true, document_.cameras.size() + document_.renderSettings.size(),
              "cameras and render settings");
    }

    void nodes() {
        bool groups = false, locks = false, attributes = false, names = false, turns = false;
        for (std::size_t k = 0; k < document_.nodes.size(); ++k) {
            const SceneNode& node = document_.nodes[k];
            groups = groups || (k > 0 && node.isGroup());
            locks = locks || node.locked;
            attributes = attributes || !node.attributes.empty();
            // With one object the entity's name may stand for it; "Object" was given by nobody.
            names = names || (!node.name.empty() && node.name != "Object" &&
                              !(holds_.entityName && node.name == document_.entity.name));
            turns = turns || std::ranges::any_of(node.placements, [](const PlacementKey& key) {
                        return key.placement.rotation != SignedPermutation{};
                    });
        }
        const bool merged = holds_.scene == SceneHeld::merged;
        const bool graph = holds_.scene == SceneHeld::seen;
        const bool rootName = !document_.nodes[0].name.empty();
        list("holds what is seen of the scene",
             {{!graph && (merged ? names : rootName),
               merged ? "names of objects" : "the root's name"},
              {!graph && groups, "groups"},
              {!graph && turns && !merged, "turns (voxels are written as they stand)"},
              {!graph && !merged && sharesModels(), "that objects share their voxels"},
              {!document_.layers.empty(), "layers"},
              {locks, "locks"},
              {attributes, "attributes of other programs"}});
    }

    [[nodiscard]] bool sharesModels() const {
        std::set<int> shown;
        for (const Instance& instance : instancesOf(document_, 0)) {
            if (!shown.insert(instance.model).second) return true;
        }
        return false;
    }

    [[nodiscard]] std::size_t modelsThatNoObjectShows() const {
        std::set<int> shown;
        for (const SceneNode& node : document_.nodes) {
            for (const ModelKey& key : node.models) shown.insert(key.model);
        }
        std::size_t unused = 0;
        for (std::size_t k = 0; k < document_.models.size(); ++k) {
            if (!shown.contains(static_cast<int>(k)) && !document_.models[k].voxels.empty()) {
                ++unused;
            }
        }
        return unused;
    }

    void entity() {
        const Entity& entity = document_.entity;
        const bool turned =
            entity.yawDegrees != 0.0 || entity.pitchDegrees != 0.0 || entity.rollDegrees != 0.0;
        list("has no words for all of the entity",
             {{!holds_.entityName && !entity.name.empty(), "its name"},
              {!holds_.anchor && entity.anchorVoxels.has_value(), "anchor"},
              {!holds_.pose && turned, "rotation"},
              {!holds_.pose && entity.scale != 1.0, "scale"},
              {!holds_.pose && entity.positionMetres != glm::dvec3(0.0), "place"},
              {!holds_.authored && document_.authored != AuthoredValues{},
               "the VoxelSize and sigma it was made with"}});
    }

    void coordinates() {
        if (holds_.coordinates) return;
        const IBox bounds = frameBounds(document_, 0);
        if (bounds.empty() || bounds.min == glm::ivec3(0)) return;
        say("has no coordinates: the model is moved by " + std::to_string(-bounds.min.x) + ", " +
            std::to_string(-bounds.min.y) + ", " + std::to_string(-bounds.min.z));
    }

    const Holds& holds_;
    const Document& document_;
    const std::string& ending_;
    std::vector<std::string> losses_;
};

}  // namespace

std::vector<std::string> lossesBy(const Holds& holds, const Document& document,
                                  const std::string& ending) {
    return Losses(holds, document, ending).run();
}

}  // namespace voxprite
