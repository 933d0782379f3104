// The palette of a .vox file: RGBA, IMAP, NOTE, MATL and MATT, and our own chunk for colour names.

#include <algorithm>
#include <charconv>

#include "core/io/vox_fields.h"
#include "core/io/vox_file.h"

namespace voxprite {

namespace {

constexpr std::size_t kRows = 32;
constexpr std::size_t kColumns = 8;

// The display slots of a row of the palette. NOTE names the last row (slots 249 ...) first. Slot
// 256 would be colour 256, which is index 0, the empty one.
std::vector<std::size_t> slotsOfNote(std::size_t note) {
    std::vector<std::size_t> slots;
    const std::size_t first = (kRows - 1 - note) * kColumns + 1;
    for (std::size_t slot = first; slot < first + kColumns && slot < 256; ++slot) {
        slots.push_back(slot);
    }
    return slots;
}

std::array<std::string, 256> namesFromRows(const std::vector<std::string>& rows,
                                           const std::array<std::uint8_t, 256>& displayOrder) {
    std::array<std::string, 256> names;
    for (std::size_t note = 0; note < rows.size(); ++note) {
        for (const std::size_t slot : slotsOfNote(note)) names[displayOrder[slot]] = rows[note];
    }
    return names;
}

// The name that all colours of each row share, empty where they differ.
std::vector<std::string> rowsFromNames(const Palette& palette) {
    std::vector<std::string> rows(kRows);
    for (std::size_t note = 0; note < kRows; ++note) {
        const std::vector<std::size_t> slots = slotsOfNote(note);
        const std::string& name = palette.names[palette.displayOrder[slots[0]]];
        const bool shared = std::all_of(slots.begin(), slots.end(), [&](std::size_t slot) {
            return palette.names[palette.displayOrder[slot]] == name;
        });
        if (shared) rows[note] = name;
    }
    return rows;
}

}  // namespace

void parseVoxColours(VoxFields& fields, VoxPaletteChunks& palette, VoxWarnings& warnings) {
    const std::size_t bytes = fields.remaining();
    if (bytes % 4 != 0 || bytes > 1024) {
        warnings.add("the palette has " + std::to_string(bytes) + " bytes instead of 1024");
    }
    palette.colours.clear();
    while (fields.remaining() >= 4 && palette.colours.size() < 255) {
        const ByteView c = fields.take(4, "a colour");
        palette.colours.emplace_back(c[0], c[1], c[2], c[3]);
    }
}

void parseVoxDisplayMap(VoxFields& fields, VoxPaletteChunks& palette) {
    const ByteView entries = fields.take(256, "the palette's display order");
    if (!fields.ok()) return;
    std::copy(entries.begin(), entries.end(), palette.displayMap.emplace().begin());
}

void parseVoxRowNames(VoxFields& fields, VoxPaletteChunks& palette, VoxWarnings& warnings) {
    const std::uint32_t names = fields.count(4, "the palette's names");
    if (names > kRows) {
        warnings.add("the palette has " + std::to_string(names) + " names for " +
                     std::to_string(kRows) + " rows; the rest is left out");
    }
    palette.rowNames.clear();
    for (std::size_t i = 0; i < names && i < kRows; ++i) {
        palette.rowNames.push_back(fields.text("the palette's names"));
    }
}

void parseVoxColourNames(VoxFields& fields, VoxPaletteChunks& palette) {
    const std::uint32_t names = fields.count(5, "the colours' names");
    palette.colourNames.emplace();
    for (std::uint32_t i = 0; i < names && fields.ok(); ++i) {
        const std::uint8_t index = fields.u8("the colours' names");
        (*palette.colourNames)[index] = fields.text("the colours' names");
    }
}

void parseVoxMaterial(VoxFields& fields, VoxPaletteChunks& palette, VoxWarnings& warnings) {
    const int id = fields.i32("a material's id");
    Properties properties = fields.properties("a material's properties");
    if (!fields.ok()) return;
    if (id < 0 || id > 256) {
        warnings.add("material " + std::to_string(id) + " belongs to no colour; it is left out");
        return;
    }
    // Writers count colours from 0 or to 256; both mean index 0, which no voxel has.
    palette.materials[static_cast<std::size_t>(id) % 256] = std::move(properties);
}

void parseVoxOldMaterial(VoxFields& fields, VoxPaletteChunks& palette, VoxWarnings& warnings) {
    constexpr std::array<const char*, 4> kTypes{"_diffuse", "_metal", "_glass", "_emit"};
    // In the order of the property bits; the names are those that MATL has for the same thing.
    constexpr std::array<const char*, 7> kValues{"_plastic", "_rough", "_spec", "_ior",
                                                 "_att",     "_flux",  "_ldr"};
    constexpr unsigned kTotalPowerBit = 7;
    const auto textFromFloat = [](float value) {
        char text[32];
        return std::string(text, std::to_chars(text, text + sizeof(text), value).ptr);
    };

    const std::uint64_t at = fields.offset();
    const int id = fields.i32("a material's id");
    const int type = fields.i32("a material's type");
    const float weight = fields.f32("a material's weight");
    const auto bits = static_cast<std::uint32_t>(fields.i32("a material's property bits"));
    Properties properties;
    for (unsigned bit = 0; bit < kValues.size(); ++bit) {
        if (((bits >> bit) & 1U) == 0) continue;
        properties[kValues[bit]] = textFromFloat(fields.f32("a material's values"));
    }
    if ((bits >> kTotalPowerBit) & 1U) properties["_total_power"] = "1";
    if (type < 0 || type > 3)
        fields.refuse(at, "a material has the unknown type " + std::to_string(type));
    if (!fields.ok()) return;
    if (id < 1 || id > 255) {
        warnings.add("material " + std::to_string(id) + " belongs to no colour; it is left out");
        return;
    }
    properties["_type"] = kTypes[static_cast<std::size_t>(type)];
    properties["_weight"] = textFromFloat(weight);
    palette.materials[static_cast<std::size_t>(id)] = std::move(properties);
}

Palette paletteFromVox(VoxPaletteChunks chunks, VoxWarnings& warnings) {
    Palette palette = Palette::standard();
    std::copy(chunks.colours.begin(), chunks.colours.end(), palette.colours.begin() + 1);
    if (chunks.displayMap) {
        std::array<bool, 256> shown{};
        for (const std::uint8_t index : *chunks.displayMap) shown[index] = true;
        const bool permutation = std::find(shown.begin(), shown.end(), false) == shown.end();
        if (permutation) {
            // The empty colour is shown nowhere; MagicaVoxel has it last.
            std::ranges::remove_copy(*chunks.displayMap, palette.displayOrder.begin() + 1,
                                     std::uint8_t{0});
        } else {
            warnings.add("the palette's display order is no permutation; it is left out");
        }
    }
    palette.names = chunks.colourNames ? std::move(*chunks.colourNames)
                                       : namesFromRows(chunks.rowNames, palette.displayOrder);
    palette.materials = std::move(chunks.materials);
    return palette;
}

void writeVoxPalette(ByteWriter& out, const Palette& palette) {
    writeChunk(out, "RGBA", [&] {
        for (std::size_t i = 1; i <= 256; ++i) {
            const Rgba8 colour = palette.colours[i % 256];
            for (int channel = 0; channel < 4; ++channel) out.u8(colour[channel]);
        }
    });
    if (palette.displayOrder != Palette::identityOrder()) {
        writeChunk(out, "IMAP", [&] {
            for (std::size_t slot = 1; slot <= 256; ++slot)
                out.u8(palette.displayOrder[slot % 256]);
        });
    }
    for (std::size_t i = 1; i <= 256; ++i) {
        if (palette.materials[i % 256].empty()) continue;
        writeChunk(out, "MATL", [&] {
            out.u32(static_cast<std::uint32_t>(i));
            writeProperties(out, palette.materials[i % 256]);
        });
    }
}

void writeVoxNames(ByteWriter& out, const Palette& palette) {
    const auto named = static_cast<std::uint32_t>(
        std::count_if(palette.names.begin(), palette.names.end(),
                      [](const std::string& name) { return !name.empty(); }));
    if (named == 0) return;
    const std::vector<std::string> rows = rowsFromNames(palette);
    writeChunk(out, "NOTE", [&] {
        out.u32(static_cast<std::uint32_t>(rows.size()));
        for (const std::string& row : rows) out.string32(row);
    });
    if (namesFromRows(rows, palette.displayOrder) == palette.names) return;
    writeChunk(out, "vpCN", [&] {
        out.u32(named);
        for (std::size_t i = 0; i < 256; ++i) {
            if (palette.names[i].empty()) continue;
            out.u8(static_cast<std::uint8_t>(i));
            out.string32(palette.names[i]);
        }
    });
}

}  // namespace voxprite
