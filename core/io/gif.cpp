#include "core/io/gif.h"

#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <memory>

#include "core/io/colour_reduction.h"

namespace voxprite {
namespace {

constexpr int kMaxGifEdge = 65'535;
constexpr int kTransparent = 0;  // in the table of colours; the palette begins at 1
constexpr std::uint8_t kLeastAlpha = 128;

int append(GifFileType* file, const GifByteType* data, int length) {
    auto& bytes = *static_cast<Bytes*>(file->UserData);
    bytes.insert(bytes.end(), data, data + length);
    return length;
}

struct Close {
    void operator()(GifFileType* file) const {
        int ignored = 0;
        EGifCloseFile(file, &ignored);
    }
};
using Gif = std::unique_ptr<GifFileType, Close>;

Failure failed(const GifFileType& file) {
    const char* reason = GifErrorString(file.Error);
    return fail(std::string("the GIF cannot be written: ") +
                (reason != nullptr ? reason : "unknown"));
}

// "Play for ever", in the way of Netscape that all viewers know.
bool putLoop(GifFileType* gif) {
    constexpr std::array<GifByteType, 3> kForEver{1, 0, 0};
    return EGifPutExtensionLeader(gif, APPLICATION_EXT_FUNC_CODE) == GIF_OK &&
           EGifPutExtensionBlock(gif, 11, "NETSCAPE2.0") == GIF_OK &&
           EGifPutExtensionBlock(gif, static_cast<int>(kForEver.size()), kForEver.data()) ==
               GIF_OK &&
           EGifPutExtensionTrailer(gif) == GIF_OK;
}

// Hundredths of a second, two at least, that add up to the milliseconds.
class Delays {
  public:
    int next(int milliseconds) {
        end_ += milliseconds;
        const auto delay =
            static_cast<int>(std::clamp<std::int64_t>((end_ + 5) / 10 - told_, 2, 65'535));
        told_ += delay;
        return delay;
    }

  private:
    std::int64_t end_ = 0;   // milliseconds
    std::int64_t told_ = 0;  // hundredths
};

bool putFrame(GifFileType* gif, const AnimationFrame& frame, int delay,
              const ReducedColours& colours) {
    GraphicsControlBlock control{};
    control.DisposalMode = DISPOSE_BACKGROUND;
    control.DelayTime = delay;
    control.TransparentColor = kTransparent;
    std::array<GifByteType, 4> block{};
    const std::size_t length = EGifGCBToExtension(&control, block.data());
    const Image& image = frame.image;
    if (EGifPutExtension(gif, GRAPHICS_EXT_FUNC_CODE, static_cast<int>(length), block.data()) !=
            GIF_OK ||
        EGifPutImageDesc(gif, 0, 0, image.width, image.height, false, nullptr) != GIF_OK) {
        return false;
    }
    std::vector<GifPixelType> row(static_cast<std::size_t>(image.width));
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const Rgba8 c = image.at(x, y);
            row[static_cast<std::size_t>(x)] =
                c.w < kLeastAlpha ? kTransparent : colours.indexOf(Rgba8(c.x, c.y, c.z, 255));
        }
        if (EGifPutLine(gif, row.data(), image.width) != GIF_OK) return false;
    }
    return true;
}

struct Colours {
    ReducedColours reduced;
    bool translucent = false;
};

Colours coloursOf(std::span<const AnimationFrame> frames) {
    ColourCount count;
    Colours colours;
    for (const AnimationFrame& frame : frames) {
        for (const Rgba8 c : frame.image.pixels) {
            colours.translucent = colours.translucent || (c.w != 0 && c.w != 255);
            if (c.w >= kLeastAlpha) count.add(Rgba8(c.x, c.y, c.z, 255));
        }
    }
    colours.reduced = reduceColours(count);
    return colours;
}

std::optional<std::string> lossOf(const Colours& colours) {
    const std::optional<std::string> reduced = colours.reduced.warning();
    if (!colours.translucent) return reduced;
    const std::string alpha = "GIF has no partial transparency: it is all or nothing";
    return reduced ? alpha + "; " + *reduced : alpha;
}

}  // namespace

Result<GifImage> writeGif(std::span<const AnimationFrame> frames) {
    if (frames.empty()) return fail("an animation needs a frame");
    const Image& first = frames.front().image;
    if (first.width < 1 || first.height < 1 || first.width > kMaxGifEdge ||
        first.height > kMaxGifEdge) {
        return fail("a GIF has 1 to " + std::to_string(kMaxGifEdge) + " pixels an edge, not " +
                    std::to_string(first.width) + " x " + std::to_string(first.height));
    }
    for (const AnimationFrame& frame : frames) {
        if (frame.image.width != first.width || frame.image.height != first.height) {
            return fail("a frame has another size than the first");
        }
    }
    const Colours colours = coloursOf(frames);
    int bits = 1;
    while (1 << bits < colours.reduced.used + 1) ++bits;
    const std::unique_ptr<ColorMapObject, void (*)(ColorMapObject*)> table(
        GifMakeMapObject(1 << bits, nullptr), GifFreeMapObject);
    if (!table) return fail("there is not enough memory to write the animation");
    for (int k = 0; k < 1 << bits; ++k) {
        const Rgba8 c = colours.reduced.palette.colours[static_cast<std::size_t>(k)];
        table->Colors[k] = {c.x, c.y, c.z};
    }

    GifImage result;
    int error = 0;
    Gif gif(EGifOpen(&result.bytes, append, &error));
    if (!gif) return fail("there is not enough memory to write the animation");
    EGifSetGifVersion(gif.get(), true);
    if (EGifPutScreenDesc(gif.get(), first.width, first.height, 8, kTransparent, table.get()) !=
            GIF_OK ||
        !putLoop(gif.get())) {
        return failed(*gif);
    }
    Delays delays;
    for (const AnimationFrame& frame : frames) {
        if (!putFrame(gif.get(), frame, delays.next(frame.milliseconds), colours.reduced)) {
            return failed(*gif);
        }
    }
    // Closing writes the end, into bytes that must still be there.
    if (EGifCloseFile(gif.release(), &error) != GIF_OK)
        return fail("the GIF cannot be written to its end");
    result.loss = lossOf(colours);
    return result;
}

}  // namespace voxprite
