#include "app/editor/panels/import_dialog.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app/editor/panels/dialog_frame.h"
#include "app/editor/panels/widgets.h"
#include "core/io/mesh_voxels.h"

namespace voxprite::editor {
namespace {

constexpr std::array kScales{
    Choice{"Longest side", "So many voxels along it"},
    Choice{"Unit of the file", "So many voxels a unit, so that parts made apart fit together"}};
constexpr std::array kUsual{32, 64, 128, 256};
constexpr std::array kUsualChoices{Choice{"32", ""}, Choice{"64", ""}, Choice{"128", ""},
                                   Choice{"256", ""}};
constexpr std::array kFillings{
    Choice{"Hollow", "The voxels of the surface"},
    Choice{"Solid", "The inside, too: looks the same until something is cut away"}};
constexpr std::array kUps{Choice{"Y", "As most programs write it"},
                          Choice{"Z", "As Blender's and CAD programs' own axes are"}};

}  // namespace

void ImportDialog::open(std::filesystem::path file) {
    file_ = std::move(file);
}

void ImportDialog::drawSize(Ui& ui) {
    int scale = byUnit_ ? 1 : 0;
    if (choiceRow(ui, "import.scale", "Sized by", scale, kScales)) byUnit_ = scale == 1;
    if (byUnit_) {
        static_cast<void>(numberRow(ui, "import.perUnit", "Voxels a unit", voxelsPerUnit_,
                                    {1e-3, 1e4, 0.05, "%.4g"},
                                    "Of the file; in .glb and .gltf a unit is a metre"));
        return;
    }
    int& voxels = options_.mesh.resolution;
    const auto usual = std::ranges::find(kUsual, voxels);
    int index = usual == kUsual.end() ? -1 : static_cast<int>(usual - kUsual.begin());
    if (choiceRow(ui, "import.usual", "Resolution", index, kUsualChoices)) {
        voxels = kUsual[static_cast<std::size_t>(index)];
    }
    double number = voxels;
    if (numberRow(ui, "import.resolution", "", number,
                  {1.0, static_cast<double>(kMaxMeshResolution), 0.3, "%.0f voxels"},
                  "Along the longest side of the mesh")) {
        voxels = static_cast<int>(std::lround(number));
    }
}

void ImportDialog::drawFilling(Ui& ui) {
    MeshReadOptions& mesh = options_.mesh;
    int filling = mesh.solid ? 1 : 0;
    if (choiceRow(ui, "import.filling", "Inside", filling, kFillings)) mesh.solid = filling == 1;
    const Result<Format> format = formatOf(file_);
    if (format && *format == Format::obj) {
        static_cast<void>(enumRow(ui, "import.up", "Up is", mesh.objUp, kUps));
    }
}

ImportDialog::Answer ImportDialog::draw(Ui& ui) {
    if (!isOpen()) return Answer::none;
    if (!beginDialog(ui, "##import", "Make voxels of a mesh", 460)) return Answer::none;
    // The key that chose the file does not answer this, too.
    const bool listens = !ImGui::IsWindowAppearing();
    const std::string text =
        file_.filename().string() +
        " holds surfaces. Each voxel takes the colour of the nearest point of them.";
    ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.textDim);
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopStyleColor();
    ImGui::Dummy(ui.theme.px(0, 4));
    drawSize(ui);
    drawFilling(ui);
    const ImVec2 button = ui.theme.px(108, 30);
    placeButtons(ui, button, 2);
    Answer answer = Answer::none;
    if (ImGui::Button("Cancel", button) || pressedKey(ImGuiKey_Escape)) answer = Answer::cancel;
    ui.probe.markItem("import.cancel");
    ImGui::SameLine();
    if (primaryButton(ui, "Import", button) || (listens && pressedEnter())) answer = Answer::import;
    ui.probe.markItem("import.accept");
    if (answer != Answer::none) {
        options_.mesh.voxelsPerUnit = byUnit_ ? voxelsPerUnit_ : 0.0;
        file_.clear();
        ImGui::CloseCurrentPopup();
    }
    endDialog();
    return answer;
}

}  // namespace voxprite::editor
