// Speed against accuracy by mouse and keyboard: the error map, the curve, A and B.
#include "core/base/file.h"
#include "tests/app/editor_window.h"
#include "tests/app/pasted.h"
#include "tests/support/must.h"

namespace voxprite::test {
namespace {

using Json = nlohmann::json;

class TradeWindow : public EditorWindow {
  protected:
    [[nodiscard]] Json trade() const { return state().at("trade"); }
    void awaitTrade(const std::string& what, const std::function<bool(const Json&)>& holds) {
        await(what, [&](const Json& now) { return holds(now.at("state").at("trade")); });
    }
    void awaitToast(const std::string& start) {
        await(start, [&](const Json& now) {
            return now.at("state").at("toast").get<std::string>().starts_with(start);
        });
    }
    // The PNG that F12 writes under this name, and that the clipboard then has, too.
    Bytes savedAndCopied(const std::string& name) {
        overTheViews();
        key("F12");
        awaitToast("Saved " + name);
        const Bytes saved = must(readFile(file(name)));
        key("ctrl+shift+c");
        awaitToast("Copied the sprite");
        EXPECT_EQ(pasted(display(), "image/png"), saved);
        return saved;
    }
    // The keys are the views' again, and no tool shows what it would do.
    void overTheViews() { settleAt({760, 787}); }
    [[nodiscard]] std::array<double, 4> rect(const std::string& item) const {
        return layout().at("items").at(item).get<std::array<double, 4>>();
    }
};

TEST_F(TradeWindow, TheErrorMapLiesOverTheSprite) {
    ASSERT_NO_FATAL_FAILURE(openFigure());
    overTheViews();
    key("shift+e");
    awaitTrade("a map", [](const Json& now) { return now.at("heat_mean") >= 0.0; });
    const double exact = trade().at("heat_mean").get<double>();
    const auto legend = rect("sprite.heat"), view = rect("view.sprite");
    EXPECT_GE(legend[0], view[0]);
    EXPECT_GE(legend[1], view[1]);
    EXPECT_LE(legend[2], view[2]);
    EXPECT_LE(legend[3], view[3]);
    // Against the voxels themselves a sprite is never right.
    click(centreOf("sprite.heat.yardstick.2"));
    awaitTrade("another map",
               [&](const Json& now) { return now.at("heat_mean").get<double>() > exact + 0.01; });
    click(centreOf("command.error_heat"));
    awaitTrade("no map", [](const Json& now) { return now.at("heat") == false; });
    EXPECT_EQ(state().at("steps"), 0);
}

TEST_F(TradeWindow, SettingsAreLookedAtHeldAgainstEachOtherAndTaken) {
    ASSERT_NO_FATAL_FAILURE(openFigure());
    // Without a B there is nothing to flip to.
    overTheViews();
    key("d");
    await("a word about it", [](const Json& now) {
        return now.at("state").at("toast").get<std::string>().find("no B") != std::string::npos;
    });
    awaitTrade("the curve",
               [](const Json& now) { return now.at("points") > 8 && now.at("busy") == false; });
    EXPECT_EQ(trade().at("b"), "");
    // The last point of the plan lies apart from the others.
    const std::string last = "trade.point." + std::to_string(trade().at("points").get<int>() - 1);
    click(centreOf(last));
    awaitTrade("B in view",
               [](const Json& now) { return now.at("b") != "" && now.at("side") == 1; });
    static_cast<void>(centreOf("sprite.side.b"));
    overTheViews();
    key("d");
    awaitTrade("A", [](const Json& now) { return now.at("side") == 0; });
    key("shift+d");
    awaitTrade("both", [](const Json& now) { return now.at("side") == 2; });
    static_cast<void>(centreOf("sprite.side.a"));
    const glm::ivec2 bar = centreOf("sprite.wipe");
    carry(bar + glm::ivec2(0, 90), bar + glm::ivec2(-110, 90));
    awaitTrade("the bar elsewhere", [](const Json& now) { return now.at("wipe") < 0.4; });
    EXPECT_EQ(state().at("steps"), 0) << "looking changes nothing";

    click(centreOf("trade.apply_b"));
    await("B in force", [](const Json& now) { return now.at("state").at("steps") == 1; });
    overTheViews();
    key("ctrl+z");
    await("A in force again", [](const Json& now) { return now.at("state").at("steps") == 0; });
    click(centreOf("trade.cheapest"));
    await("the cheapest in force", [](const Json& now) {
        return now.at("state").at("toast").get<std::string>().starts_with("Cheapest within");
    });
    EXPECT_EQ(state().at("steps"), 1);
}

// F12 and Ctrl+Shift+C take the side that shows.
TEST_F(TradeWindow, ThePictureIsThatOfTheSideThatShows) {
    ASSERT_NO_FATAL_FAILURE(openFigure());
    const Bytes alone = savedAndCopied("figure.png");
    overTheViews();
    key("d");  // shows the curve, as there is no B
    awaitTrade("the curve",
               [](const Json& now) { return now.at("points") > 8 && now.at("busy") == false; });
    click(centreOf("trade.point." + std::to_string(trade().at("points").get<int>() - 1)));
    awaitTrade("B in view",
               [](const Json& now) { return now.at("b") != "" && now.at("side") == 1; });
    const Bytes b = savedAndCopied("figure-2.png");
    EXPECT_NE(b, alone);
    overTheViews();
    key("d");
    awaitTrade("A", [](const Json& now) { return now.at("side") == 0; });
    EXPECT_EQ(savedAndCopied("figure-3.png"), alone);
    overTheViews();
    key("shift+d");
    awaitTrade("both", [](const Json& now) { return now.at("side") == 2; });
    EXPECT_EQ(savedAndCopied("figure-4.png"), alone) << "of both that of the settings in force";

    click(centreOf("trade.apply_b"));
    await("B in force", [](const Json& now) { return now.at("state").at("steps") == 1; });
    EXPECT_EQ(savedAndCopied("figure-5.png"), b) << "what was seen as B is what it looks like";
}

}  // namespace
}  // namespace voxprite::test
