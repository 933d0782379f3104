// The palette: the colour in hand, the swatches, the ramp and the variants.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "app/editor/panels/palette_editor.h"
#include "app/editor/panels/ui.h"
#include "app/editor/views/variant_pictures.h"

namespace voxprite::editor {

class PalettePanel {
  public:
    // `editor` outlives this.
    explicit PalettePanel(PaletteEditor& editor) : editor_(editor) {}
    // Into the current ImGui window.
    void draw(Ui& ui);

  private:
    // palette_panel.cpp
    void drawColour(Ui& ui);
    void drawPicker(Ui& ui);
    [[nodiscard]] bool drawHueRow(Ui& ui, Rgba8 shown, std::array<float, 3>& rgb);
    void drawToolbar(Ui& ui);
    void drawRamp(Ui& ui);
    // palette_swatches.cpp
    void drawSwatches(Ui& ui, float height);
    void useSwatch(Ui& ui, std::size_t slot);
    void dropSwatch(Ui& ui, std::size_t slot);
    void drawMenu(Ui& ui);
    // palette_variants.cpp
    void drawVariants(Ui& ui);
    void drawVariant(Ui& ui, std::size_t cell, ImVec2 size);
    void drawVariantMenu(Ui& ui, std::size_t variant);

    PaletteEditor& editor_;
    VariantPictures pictures_;
    std::uint8_t menuFor_ = 0;  // the colour whose menu is open
    std::size_t dragged_ = 0;   // the slot that is dragged; 0: none
    std::string name_;          // of the variant that is being renamed
    // The colour that the picker shows as hue, saturation and value, each 0 ... 1: what eight bits
    // a channel would forget, such as the hue of a grey.
    std::array<float, 3> hsv_{};
    Rgba8 hsvOf_{0};
};

}  // namespace voxprite::editor
