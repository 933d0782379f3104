#include "core/sheet/sheet_json.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>

#include "core/io/json_text.h"
#include "core/model/playback.h"

namespace voxprite {
namespace {

using Json = nlohmann::ordered_json;

Json rectangle(glm::ivec2 corner, glm::ivec2 size) {
    return {{"x", corner.x}, {"y", corner.y}, {"w", size.x}, {"h", size.y}};
}

Json sizeOf(glm::ivec2 size) {
    return {{"w", size.x}, {"h", size.y}};
}

Json point(glm::dvec2 px) {
    return {px.x, px.y};
}

std::string degrees(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

std::string viewName(const SheetSprite& sprite, const SheetOptions& options) {
    std::string name = "yaw" + degrees(sprite.yawDegrees);
    if (options.pitchesDegrees.size() > 1) name += "_pitch" + degrees(sprite.pitchDegrees);
    return name;
}

// Where several are the same the later ones are numbered.
std::vector<std::string> numbered(const std::vector<std::string>& names) {
    const std::set<std::string> all(names.begin(), names.end());
    std::set<std::string> used;
    std::vector<std::string> keys;
    for (const std::string& name : names) {
        std::string key = name;
        for (int n = 2; used.contains(key) || (key != name && all.contains(key)); ++n) {
            key = name + " " + std::to_string(n);
        }
        used.insert(key);
        keys.push_back(std::move(key));
    }
    return keys;
}

std::vector<std::string> keysOf(const std::vector<SheetSocket>& sockets) {
    std::vector<std::string> names;
    for (const SheetSocket& socket : sockets) names.push_back(jsonTextFromBytes(socket.name));
    return numbered(names);
}

// What the clips' tags begin with. Engines make animations and files of these names: Godot's may
// not hold these signs.
std::vector<std::string> keysOf(const std::vector<Clip>& clips) {
    std::vector<std::string> names;
    for (const Clip& clip : clips) {
        std::string name = jsonTextFromBytes(clip.name);
        std::ranges::replace_if(
            name, [](char c) { return std::string_view("/:,[").find(c) != std::string_view::npos; },
            '_');
        names.push_back(std::move(name));
    }
    return numbered(names);
}

int millisecondsOf(const Clip& clip, int frame) {
    return static_cast<int>(std::lround(frameSeconds(clip, frame) * 1000.0));
}

Json frameOf(std::size_t index, const Sheet& sheet, const Document& document,
             const SheetOptions& options, const std::string& stem) {
    const SheetSprite& sprite = sheet.sprites[index];
    Json sockets = Json::object();
    const std::vector<std::string> keys = keysOf(sprite.sockets);
    for (std::size_t k = 0; k < keys.size(); ++k) {
        const SheetSocket& socket = sprite.sockets[k];
        sockets[keys[k]] = {{"px", point(socket.px)}, {"visible", socket.visible}};
    }
    // Phaser finds the frames of Aseprite's tags by their numbers.
    return {{"filename", std::to_string(index)},
            {"frame", rectangle(sprite.at, sprite.size)},
            {"rotated", false},
            {"trimmed", sprite.size != sheet.cellPx},
            {"spriteSourceSize", rectangle(sprite.inCell, sprite.size)},
            {"sourceSize", sizeOf(sheet.cellPx)},
            {"duration", frameMilliseconds(document, sprite.frame)},
            {"voxprite",
             {{"name", jsonTextFromBytes(stem) + "/" + viewName(sprite, options) + "/" +
                           std::to_string(sprite.frame)},
              {"direction", sprite.direction},
              {"yaw", sprite.yawDegrees},
              {"pitch", sprite.pitchDegrees},
              {"frame", sprite.frame},
              {"anchor", point(sprite.anchorPx)},
              {"sockets", sockets}}}};
}

// The clips whose frames the sheet has, as runs of sprites of one view; without clips, all frames.
Json tagsOf(const Sheet& sheet, const Document& document, const SheetOptions& options) {
    Json tags = Json::array();
    const auto sameView = [](const SheetSprite& a, const SheetSprite& b) {
        return a.direction == b.direction && a.pitchDegrees == b.pitchDegrees;
    };
    std::vector<Clip> clips = document.clips;
    if (clips.empty()) clips.push_back({.name = "frames", .last = kMaxFrames - 1});
    const std::vector<std::string> keys = keysOf(clips);
    for (std::size_t from = 0; from < sheet.sprites.size();) {
        std::size_t to = from + 1;
        while (to < sheet.sprites.size() && sameView(sheet.sprites[from], sheet.sprites[to])) ++to;
        for (std::size_t k = 0; k < clips.size(); ++k) {
            const Clip& clip = clips[k];
            const auto within = [&](const SheetSprite& sprite) {
                return sprite.frame >= clip.first && sprite.frame <= clip.last;
            };
            const auto begin = sheet.sprites.begin() + static_cast<std::ptrdiff_t>(from);
            const auto end = sheet.sprites.begin() + static_cast<std::ptrdiff_t>(to);
            const auto first = std::find_if(begin, end, within);
            if (first == end) continue;
            const auto after = std::find_if_not(first, end, within);
            Json tag = {{"name", keys[k] + "_" + viewName(sheet.sprites[from], options)},
                        {"from", first - sheet.sprites.begin()},
                        {"to", after - sheet.sprites.begin() - 1},
                        {"direction", "forward"},
                        {"color", "#000000ff"}};
            if (!clip.loop) tag["repeat"] = "1";  // none is for ever
            tags.push_back(std::move(tag));
        }
        from = to;
    }
    return tags;
}

Json clipsOf(const Document& document) {
    Json clips = Json::array();
    for (const Clip& clip : document.clips) {
        // A frame of several clips has the duration of the first of them.
        Json durations = Json::array();
        for (int frame = clip.first; frame <= clip.last; ++frame) {
            durations.push_back(millisecondsOf(clip, frame));
        }
        clips.push_back({{"name", jsonTextFromBytes(clip.name)},
                         {"first", clip.first},
                         {"last", clip.last},
                         {"loop", clip.loop},
                         {"durations", std::move(durations)}});
    }
    return clips;
}

}  // namespace

std::string pictureName(const std::string& imageName, const std::string& picture) {
    if (picture.empty()) return imageName;
    const std::filesystem::path path(imageName);
    std::string name = path.stem().string() + "." + picture + path.extension().string();
    // A variant may be called "day/night"; its picture lies beside the others all the same.
    std::ranges::replace(name, '/', '_');
    return (path.parent_path() / name).string();
}

bool sheetJsonNames(const std::string& text, const std::string& imageName,
                    const std::string& picture) {
    const Result<Json> json = parseJson(text);
    if (!json || !json->is_object()) return false;
    const auto at = [&](const char* pointer) {
        const Json::json_pointer place(pointer);
        return json->contains(place) ? json->at(place) : Json();
    };
    if (at("/meta/app") != "voxprite" || at("/meta/image") != jsonTextFromBytes(imageName)) {
        return false;
    }
    if (picture == imageName) return true;
    const Json images = at("/meta/voxprite/images");
    return std::ranges::any_of(
        images, [&](const Json& image) { return image == jsonTextFromBytes(picture); });
}

int frameMilliseconds(const Document& document, int frame) {
    for (const Clip& clip : document.clips) {
        if (frame < clip.first || frame > clip.last) continue;
        return millisecondsOf(clip, frame);
    }
    return static_cast<int>(std::lround(1000.0 / Clip().framesPerSecond));
}

std::string sheetJson(const Sheet& sheet, const Document& document, const GameProfile& profile,
                      const SheetOptions& options, const std::string& imageName) {
    const std::string stem = std::filesystem::path(imageName).stem().string();
    Json frames = Json::array();
    for (std::size_t k = 0; k < sheet.sprites.size(); ++k) {
        frames.push_back(frameOf(k, sheet, document, options, stem));
    }
    Json images = Json::object();
    for (const SheetPicture& picture : sheet.pictures) {
        if (picture.name.empty()) continue;
        images[jsonTextFromBytes(picture.name)] =
            jsonTextFromBytes(pictureName(imageName, picture.name));
    }
    const Image& image = sheet.pictures.front().image;
    const Json anchor = {{"frame", 0},
                         {"bounds", rectangle({0, 0}, sheet.cellPx)},
                         {"pivot", {{"x", sheet.anchorPixel.x}, {"y", sheet.anchorPixel.y}}}};
    const Json json = {
        {"frames", frames},
        {"meta",
         {{"app", "voxprite"},
          {"version", "1"},
          {"image", jsonTextFromBytes(imageName)},
          {"format", "RGBA8888"},
          {"size", sizeOf({image.width, image.height})},
          {"scale", "1"},
          {"frameTags", tagsOf(sheet, document, options)},
          {"layers",
           Json::array({{{"name", "sprite"}, {"opacity", 255}, {"blendMode", "normal"}}})},
          {"slices",
           Json::array({{{"name", "anchor"}, {"color", "#ff8000ff"}, {"keys", {anchor}}}})},
          {"voxprite",
           {{"voxel_size_metres", profile.voxelSizeMetres},
            {"sigma", profile.sigma},
            {"pixel_metres", sheet.metresPerPx},
            {"directions", options.directions},
            {"pitches", options.pitchesDegrees},
            {"depth_range_metres", sheet.depthRangeMetres},
            {"clips", clipsOf(document)},
            {"images", images}}}}}};
    return json.dump(2) + "\n";
}

}  // namespace voxprite
