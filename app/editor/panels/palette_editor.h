// What is chosen in the palette, and the edits of it that commands and the panel share. Knows
// neither window nor files.
#pragma once

#include <array>
#include <vector>

#include "app/editor/session/session.h"
#include "app/editor/settings/settings.h"
#include "core/edit/palette_edits.h"

namespace voxprite::editor {

class PaletteEditor {
  public:
    // Both outlive this.
    PaletteEditor(const Session& session, EditorSettings& settings)
        : session_(session), settings_(settings) {}

    // The colour in hand, which tools draw with, is always among the chosen ones.
    [[nodiscard]] std::uint8_t inHand() const { return settings_.tool.colour; }
    // In display order.
    [[nodiscard]] std::vector<std::uint8_t> chosen() const;
    [[nodiscard]] bool isChosen(std::uint8_t index) const;
    // This one alone; from the one in hand to this in display order; in or out of the chosen ones.
    void choose(std::uint8_t index);
    void chooseTo(std::uint8_t index);
    void toggle(std::uint8_t index);
    // The next or last place in display order that is not vacant.
    void step(int slots);

    // What the palette would be; equal to the present one where an edit makes no sense. Those over
    // "the chosen" take all colours where only the one in hand is chosen and one alone means
    // nothing to them.
    [[nodiscard]] const Palette& palette() const { return session_.document().palette; }
    [[nodiscard]] Action change(std::string label, Palette after) const;
    [[nodiscard]] Action setColour(Rgba8 colour, std::uint64_t mergeKey) const;
    // Nothing where there is no place left. The copy is then in hand.
    [[nodiscard]] std::optional<Action> duplicate();
    [[nodiscard]] bool canSwap() const { return chosen().size() == 2; }
    [[nodiscard]] Action swap() const;
    [[nodiscard]] bool canGrade() const { return chosen().size() > 2; }
    [[nodiscard]] Action gradient() const;
    [[nodiscard]] Action sort(PaletteOrder order) const;
    [[nodiscard]] Action makeRamp() const;
    // For the chosen ones, or for all that voxels use.
    [[nodiscard]] Action suggestRamps() const;
    [[nodiscard]] Action removeRamp() const;
    [[nodiscard]] Action moveRampStep(std::size_t ramp, std::size_t from, std::size_t to,
                                      std::uint64_t mergeKey) const;
    [[nodiscard]] Action removeUnused() const;
    // Voxels of `from` take the colour `to`, in all objects.
    [[nodiscard]] Action recolour(std::uint8_t from, std::uint8_t to) const;
    [[nodiscard]] bool canAddVariant() const {
        return palette().variants.size() < kMaxPaletteVariants;
    }
    // In the colours that are shown.
    [[nodiscard]] Action addVariant(const std::string& name) const;
    [[nodiscard]] Action duplicateVariant(std::size_t variant) const;

    // How many voxels have each colour, as of now; and as the panel shows it, which may lag behind
    // for a moment where counting takes long.
    [[nodiscard]] ColourCounts counts() const { return colourCounts(session_.document()); }
    [[nodiscard]] const ColourCounts& shownCounts(double nowSeconds);

  private:
    [[nodiscard]] std::size_t slotOf(std::uint8_t index) const;
    [[nodiscard]] std::vector<std::uint8_t> chosenOrAll() const;
    [[nodiscard]] Palette withVariant(VariantIndex source, const std::string& name) const;

    const Session& session_;
    EditorSettings& settings_;
    std::array<bool, 256> others_{};  // chosen besides the colour in hand
    ColourCounts counts_{};
    std::uint64_t countedRevision_ = 0;
    double countAgainSeconds_ = 0.0;
};

}  // namespace voxprite::editor
