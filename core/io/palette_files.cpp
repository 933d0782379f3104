#include "core/io/palette_files.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <set>

#include "core/base/ending.h"
#include "core/base/file.h"
#include "core/io/png.h"

namespace voxprite {

namespace {

constexpr std::size_t kMostColours = 255;

bool isBlank(char c) {
    return c == ' ' || c == '\t';
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
    return text;
}

// Takes a text line by line and knows where it is.
class Lines {
  public:
    explicit Lines(std::string_view text) : rest_(text) {}

    // Without its end, "\n" or "\r\n"; nothing after the last.
    [[nodiscard]] std::optional<std::string_view> next() {
        if (rest_.empty()) return std::nullopt;
        ++number_;
        const std::size_t end = rest_.find('\n');
        std::string_view line = rest_.substr(0, end);
        rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
        if (line.ends_with('\r')) line.remove_suffix(1);
        return line;
    }
    // Of the line last taken.
    [[nodiscard]] Failure fail(std::string message) const {
        return failAtLine(std::max(number_, 1), 1, std::move(message));
    }

  private:
    std::string_view rest_;
    int number_ = 0;
};

// The next word as a number from 0 to `most`, taken from the front of `line`.
std::optional<int> takeNumber(std::string_view& line, int most) {
    line = trimmed(line);
    int value = 0;
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), value);
    const auto length = static_cast<std::size_t>(end - line.data());
    const bool ends = length == line.size() || isBlank(line[length]);
    if (error != std::errc() || !ends || value < 0 || value > most) return std::nullopt;
    line.remove_prefix(length);
    return value;
}

// Three numbers from 0 to 255, taken from the front of `line`.
std::optional<Rgba8> takeColour(std::string_view& line) {
    Rgba8 colour(0, 0, 0, 255);
    for (int channel = 0; channel < 3; ++channel) {
        const std::optional<int> value = takeNumber(line, 255);
        if (!value) return std::nullopt;
        colour[channel] = static_cast<std::uint8_t>(*value);
    }
    return colour;
}

std::string tooMany(std::size_t count) {
    return "there are " + std::string(count > kMostColours ? "more than 255" : "too many") +
           " colours; a palette holds 255";
}

std::string numbersOf(Rgba8 colour) {
    return std::to_string(colour.x) + " " + std::to_string(colour.y) + " " +
           std::to_string(colour.z);
}

constexpr Rgba8 kVacant{0, 0, 0, 0};

// The colours of squares side by side, each of one colour and as high as the picture; none where
// the picture is something else.
std::optional<std::vector<Rgba8>> squaresOf(const Image& image) {
    if (image.width % image.height != 0) return std::nullopt;
    std::vector<Rgba8> colours;
    for (int x = 0; x < image.width; x += image.height) colours.push_back(image.at(x, 0));
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (image.at(x, y) != colours[static_cast<std::size_t>(x / image.height)]) {
                return std::nullopt;
            }
        }
    }
    return colours;
}

}  // namespace

Result<ColourList> readGimpPalette(std::string_view text) {
    Lines lines(text);
    const auto first = lines.next();
    if (!first || trimmed(*first) != "GIMP Palette") {
        return lines.fail("the first line must be \"GIMP Palette\"");
    }
    ColourList colours;
    bool hasAlpha = false;
    while (const auto line = lines.next()) {
        std::string_view rest = trimmed(*line);
        if (rest.empty() || rest.starts_with('#')) continue;
        if (rest.starts_with("Name:") || rest.starts_with("Columns:")) continue;
        if (rest.starts_with("Channels:")) {
            hasAlpha = rest.ends_with("RGBA");
            continue;
        }
        const std::optional<Rgba8> colour = takeColour(rest);
        if (colour && hasAlpha && !takeNumber(rest, 255))
            return lines.fail("a colour without alpha");
        if (!colour) return lines.fail("three numbers from 0 to 255 and a name must stand here");
        if (colours.size() == kMostColours) return lines.fail(tooMany(kMostColours + 1));
        const std::string_view name = trimmed(rest);
        colours.push_back({*colour, name == "Untitled" ? std::string() : std::string(name)});
    }
    if (colours.empty()) return lines.fail("the palette has no colour");
    return colours;
}

std::string writeGimpPalette(const ColourList& colours, const std::string& name) {
    // A name that broke its line would be read as a colour.
    const auto oneLine = [](std::string text) {
        std::replace_if(
            text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
        return text;
    };
    std::string text = "GIMP Palette\nName: " + oneLine(name) + "\nColumns: 16\n#\n";
    for (const NamedColour& each : colours) {
        if (each.colour == kVacant) continue;
        text += numbersOf(each.colour);
        if (!each.name.empty()) text += "\t" + oneLine(each.name);
        text += '\n';
    }
    return text;
}

Result<ColourList> readJascPalette(std::string_view text) {
    Lines lines(text);
    const auto mark = lines.next();
    if (!mark || trimmed(*mark) != "JASC-PAL") {
        return lines.fail("the first line must be \"JASC-PAL\"");
    }
    const auto version = lines.next();
    if (!version || trimmed(*version) != "0100") {
        return lines.fail("the second line must be the version, \"0100\"");
    }
    std::string_view number = lines.next().value_or("");
    const std::optional<int> count = takeNumber(number, 1 << 16);
    if (!count || !trimmed(number).empty()) {
        return lines.fail("the third line must be the number of colours");
    }
    ColourList colours;
    while (const auto line = lines.next()) {
        std::string_view rest = trimmed(*line);
        if (rest.empty()) continue;
        const std::optional<Rgba8> colour = takeColour(rest);
        const bool hasAlpha = colour && !trimmed(rest).empty();
        if (!colour || (hasAlpha && !takeNumber(rest, 255)) || !trimmed(rest).empty()) {
            return lines.fail("three numbers from 0 to 255 must stand here");
        }
        if (colours.size() == static_cast<std::size_t>(*count)) {
            return lines.fail("there are more colours than the " + std::to_string(*count) +
                              " announced");
        }
        // Programs always write 256: the last has no place.
        colours.push_back({*colour, {}});
        if (colours.size() > kMostColours + 1) return lines.fail(tooMany(colours.size()));
    }
    if (colours.size() != static_cast<std::size_t>(*count)) {
        return lines.fail("the file ends after " + std::to_string(colours.size()) + " of " +
                          std::to_string(*count) + " colours");
    }
    if (colours.empty()) return lines.fail("the palette has no colour");
    if (colours.size() > kMostColours) colours.pop_back();
    return colours;
}

std::string writeJascPalette(const ColourList& colours) {
    const auto count = std::count_if(colours.begin(), colours.end(), [](const NamedColour& each) {
        return each.colour != kVacant;
    });
    std::string text = "JASC-PAL\r\n0100\r\n" + std::to_string(count) + "\r\n";
    for (const NamedColour& each : colours) {
        if (each.colour != kVacant) text += numbersOf(each.colour) + "\r\n";
    }
    return text;
}

Result<ColourList> readPalettePicture(ByteView png) {
    const Result<Image> image = readPng(png);
    if (!image) return Failure(image.error());
    ColourList colours;
    const std::vector<Rgba8> places = squaresOf(*image).value_or(image->pixels);
    if (places.size() <= kMostColours + 1) {
        for (const Rgba8 pixel : places) {
            const Rgba8 opaque(pixel.x, pixel.y, pixel.z, 255);
            colours.push_back({pixel.w == 0 ? kVacant : opaque, {}});
        }
        if (colours.size() > kMostColours) colours.pop_back();
        while (!colours.empty() && colours.back().colour == kVacant) colours.pop_back();
    } else {
        std::set<std::array<std::uint8_t, 3>> seen;
        for (const Rgba8 pixel : image->pixels) {
            if (pixel.w == 0 || !seen.insert({pixel.x, pixel.y, pixel.z}).second) continue;
            if (colours.size() == kMostColours) return fail(tooMany(kMostColours + 1));
            colours.push_back({Rgba8(pixel.x, pixel.y, pixel.z, 255), {}});
        }
    }
    if (colours.empty()) return fail("the picture has no opaque pixel, and so no colour");
    return colours;
}

Result<Bytes> writePalettePicture(const ColourList& colours) {
    if (colours.size() > kMostColours) return fail(tooMany(colours.size()));
    Image image(256, 1);
    for (std::size_t i = 0; i < colours.size(); ++i) image.pixels[i] = colours[i].colour;
    return writePng(image);
}

namespace {

enum class Kind : std::uint8_t { gimp, jasc, picture };

Result<Kind> kindOf(const std::filesystem::path& path) {
    const std::string ending = lowerEndingOf(path);
    if (ending == ".gpl") return Kind::gimp;
    if (ending == ".pal") return Kind::jasc;
    if (ending == ".png") return Kind::picture;
    return failInFile(path.string(), "a file of colours ends in .gpl, .pal or .png");
}

Result<ColourList> readAs(Kind kind, const Bytes& bytes) {
    if (kind == Kind::picture) return readPalettePicture(bytes);
    const std::string text(bytes.begin(), bytes.end());
    return kind == Kind::gimp ? readGimpPalette(text) : readJascPalette(text);
}

Result<Bytes> writeAs(Kind kind, const ColourList& colours, const std::string& name) {
    if (kind == Kind::picture) return writePalettePicture(colours);
    const std::string text =
        kind == Kind::gimp ? writeGimpPalette(colours, name) : writeJascPalette(colours);
    return Bytes(text.begin(), text.end());
}

}  // namespace

bool isFileOfColours(const std::filesystem::path& path) {
    return kindOf(path).has_value();
}

Result<ColourList> loadColours(const std::filesystem::path& path) {
    const Result<Kind> kind = kindOf(path);
    if (!kind) return Failure(kind.error());
    const auto read = [&](const Bytes& bytes) { return readAs(*kind, bytes); };
    return inFile(readFile(path).and_then(read), path.string());
}

Status saveColours(const std::filesystem::path& path, const ColourList& colours) {
    const Result<Kind> kind = kindOf(path);
    if (!kind) return Failure(kind.error());
    const auto write = [&](const Bytes& bytes) {
        return writeFileAtomically(path, ByteView(bytes));
    };
    return inFile(writeAs(*kind, colours, path.stem().string()).and_then(write), path.string());
}

}  // namespace voxprite
