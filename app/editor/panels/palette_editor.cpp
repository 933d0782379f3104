#include "app/editor/panels/palette_editor.h"

#include <algorithm>
#include <chrono>

#include "core/edit/make_action.h"

namespace voxprite::editor {

std::size_t PaletteEditor::slotOf(std::uint8_t index) const {
    const auto& order = palette().displayOrder;
    return static_cast<std::size_t>(std::ranges::find(order, index) - order.begin());
}

bool PaletteEditor::isChosen(std::uint8_t index) const {
    return index == inHand() || others_[index];
}

std::vector<std::uint8_t> PaletteEditor::chosen() const {
    std::vector<std::uint8_t> all;
    for (const std::uint8_t index : palette().displayOrder) {
        if (index != 0 && isChosen(index)) all.push_back(index);
    }
    return all;
}

std::vector<std::uint8_t> PaletteEditor::chosenOrAll() const {
    std::vector<std::uint8_t> indices = chosen();
    if (indices.size() < 2) {
        indices.assign(palette().displayOrder.begin() + 1, palette().displayOrder.end());
    }
    return indices;
}

void PaletteEditor::choose(std::uint8_t index) {
    if (index == 0) return;
    others_ = {};
    settings_.tool.colour = index;
}

void PaletteEditor::chooseTo(std::uint8_t index) {
    if (index == 0) return;
    const auto [first, last] = std::minmax({slotOf(inHand()), slotOf(index)});
    others_ = {};
    for (std::size_t slot = first; slot <= last; ++slot) {
        const std::uint8_t each = palette().displayOrder[slot];
        others_[each] = each != inHand();
    }
}

void PaletteEditor::toggle(std::uint8_t index) {
    if (index == 0) return;
    if (index != inHand()) {
        others_[index] = !others_[index];
        return;
    }
    // The one in hand goes: another of the chosen ones takes its place.
    const auto next = std::ranges::find(others_, true);
    if (next == others_.end()) return;
    settings_.tool.colour = static_cast<std::uint8_t>(next - others_.begin());
    *next = false;
}

void PaletteEditor::step(int slots) {
    int slot = static_cast<int>(slotOf(inHand()));
    for (int tries = 0; tries < 255; ++tries) {
        slot = (slot - 1 + slots + 255) % 255 + 1;
        const std::uint8_t index = palette().displayOrder[static_cast<std::size_t>(slot)];
        if (!palette().isVacant(index)) return choose(index);
    }
}

Action PaletteEditor::change(std::string label, Palette after) const {
    return makeAction(std::move(label), PaletteEdit{palette(), std::move(after)});
}

Action PaletteEditor::setColour(Rgba8 colour, std::uint64_t mergeKey) const {
    Action action =
        change("Palette colour", withColour(palette(), session_.variant(), inHand(), colour));
    action.mergeKey = mergeKey;
    return action;
}

std::optional<Action> PaletteEditor::duplicate() {
    const std::optional<std::uint8_t> place = freeIndex(palette(), counts());
    if (!place) return std::nullopt;
    const std::uint8_t from = inHand();
    choose(*place);
    return change("Duplicate colour", withDuplicate(palette(), from, *place));
}

Action PaletteEditor::swap() const {
    const auto pair = chosen();
    return change("Swap colours", withSwapped(palette(), pair.front(), pair.back()));
}

Action PaletteEditor::gradient() const {
    return change("Gradient", withGradient(palette(), session_.variant(), chosen()));
}

Action PaletteEditor::sort(PaletteOrder order) const {
    return change("Sort palette", withOrder(palette(), chosenOrAll(), order, counts()));
}

Action PaletteEditor::makeRamp() const {
    return change("Make ramp", withRamp(palette(), chosen()));
}

Action PaletteEditor::suggestRamps() const {
    std::vector<std::uint8_t> indices = chosenOrAll();
    if (chosen().size() < 2) {
        const ColourCounts used = counts();
        std::erase_if(indices, [&](std::uint8_t index) { return used[index] == 0; });
    }
    return change("Suggest ramps", withSuggestedRamps(palette(), indices));
}

Action PaletteEditor::removeRamp() const {
    const auto ramp = palette().rampOf(inHand());
    return change("Remove ramp", ramp ? withoutRamp(palette(), *ramp) : palette());
}

Action PaletteEditor::moveRampStep(std::size_t ramp, std::size_t from, std::size_t to,
                                   std::uint64_t mergeKey) const {
    Action action = change("Reorder ramp", withRampStepMoved(palette(), ramp, from, to));
    action.mergeKey = mergeKey;
    return action;
}

Action PaletteEditor::removeUnused() const {
    return change("Remove unused colours", withoutUnused(palette(), counts()));
}

Action PaletteEditor::recolour(std::uint8_t from, std::uint8_t to) const {
    Action action = voxprite::recolour(session_.document(), from, to);
    // Few are found here and now; many go beyond what a step holds, or take long.
    if (counts()[from] <= kLongStepVoxels && !makeParts(action, session_.document())) return {};
    return action;
}

Palette PaletteEditor::withVariant(VariantIndex source, const std::string& name) const {
    if (!canAddVariant()) return palette();
    return withVariantAdded(palette(), source, freeVariantName(palette(), name));
}

Action PaletteEditor::addVariant(const std::string& name) const {
    return change("Add palette variant", withVariant(session_.variant(), name));
}

Action PaletteEditor::duplicateVariant(std::size_t variant) const {
    return change("Duplicate palette variant",
                  withVariant(variant, palette().variants[variant].name));
}

const ColourCounts& PaletteEditor::shownCounts(double nowSeconds) {
    // Counting takes at most a twentieth of the time.
    constexpr double kIdleShare = 20.0;
    if (countedRevision_ == session_.modelRevision() || nowSeconds < countAgainSeconds_) {
        return counts_;
    }
    const auto start = std::chrono::steady_clock::now();
    counts_ = counts();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    countAgainSeconds_ = nowSeconds + kIdleShare * took.count();
    countedRevision_ = session_.modelRevision();
    return counts_;
}

}  // namespace voxprite::editor
