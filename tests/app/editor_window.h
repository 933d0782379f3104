// The editor in a real window: an X server without a screen (Xvfb), the program, and xdotool as the
// hand. Widgets are found by name in the layout that the program writes.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <glm/vec2.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace voxprite::test {

class EditorWindow : public testing::Test {
  protected:
    // Starts an X server of its own with a screen of this size.
    void startDisplay(glm::ivec2 screenPx);
    void setResolution(int dotsPerInch);  // Xft.dpi: 96 is content scale 1
    void startEditor(std::vector<std::string> arguments);
    // The editor on a file "figure.vox" that holds test::figure(), at 1280x800.
    void openFigure();
    // As at the very first start; before startEditor().
    void showTour() { showsTour_ = true; }
    // Runs the editor to its end; its exit status.
    [[nodiscard]] int runEditor(std::vector<std::string> arguments);

    // What the program last said about itself; null before it said anything.
    [[nodiscard]] nlohmann::json layout() const;
    [[nodiscard]] nlohmann::json state() const;
    // Waits until it holds; fails the test, naming `what`, when it never does.
    void await(const std::string& what, const std::function<bool(const nlohmann::json&)>& holds);
    [[nodiscard]] glm::ivec2 centreOf(const std::string& item);

    void moveTo(glm::ivec2 at);
    void click(glm::ivec2 at, int button = 1);
    void drag(glm::ivec2 from, glm::ivec2 to, int button = 1);
    // Waits until the program has seen the pointer there, and so all that was done before.
    void settleAt(glm::ivec2 at);
    // Each step is seen: what is carried is seen over what lies below.
    void carry(glm::ivec2 from, glm::ivec2 to);
    // With a modifier held, such as "ctrl".
    void clickWith(const std::string& modifier, glm::ivec2 at);
    void key(const std::string& chord);
    void keyDown(const std::string& name);
    void keyUp(const std::string& name);
    void type(const std::string& text);

    [[nodiscard]] std::filesystem::path file(const std::string& name) const {
        return folder_ / name;
    }
    [[nodiscard]] const std::string& display() const { return server_.name(); }
    [[nodiscard]] std::string said() const;  // the program's output
    [[nodiscard]] Process& editor() { return editor_; }

  private:
    void xdotool(const std::string& arguments) const;
    [[nodiscard]] std::vector<std::string> environment() const;

    TemporaryFolder folder_;
    bool showsTour_ = false;
    VirtualDisplay server_;
    Process editor_;
};

}  // namespace voxprite::test
