#include <bit>
#include <limits>
#include <span>

#include "core/base/hash.h"
#include "core/io/svo_file_format.h"

namespace voxprite {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays are written as they stand");

constexpr std::uint64_t kMaxElements = std::numeric_limits<std::uint32_t>::max();

class SvoWriter {
  public:
    explicit SvoWriter(const SvoFile& file) : file_(file) {}

    Result<Bytes> run() {
        if (Status s = check(); !s) return tl::unexpected(s.error());
        writeModels();
        writePalette();
        writeClips();
        writeAuthored();
        writeSockets();
        // What texts and arrays are counted in has 32 bits.
        if (payloadCount_ > kMaxElements || nodeCount_ > kMaxElements ||
            out(svo::STRS).size() > kMaxElements) {
            return fail("the models are too many for one .svo file");
        }
        return assemble();
    }

  private:
    [[nodiscard]] ByteWriter& out(svo::Section section) { return sections_[section]; }

    [[nodiscard]] Status check() const {
        for (const SvoModel& model : file_.models) {
            if (Status s = svo::checkModel(model); !s) return s;
        }
        for (const SvoClip& clip : file_.clips) {
            if (Status s = svo::checkClip(clip, file_.models); !s) return s;
        }
        for (const SvoSocket& socket : file_.sockets) {
            if (Status s = svo::checkSocket(socket, file_); !s) return s;
        }
        for (const std::string& name : file_.colourNames) {
            if (Status s = svo::checkText(name); !s) return s;
        }
        if (Status s = svo::checkValues(file_); !s) return s;
        return svo::checkLimits(file_);
    }

    void writeText(ByteWriter& to, const std::string& text) {
        ByteWriter& texts = out(svo::STRS);
        to.u32(text.empty() ? 0 : static_cast<std::uint32_t>(texts.size()));
        to.u32(static_cast<std::uint32_t>(text.size()));
        texts.raw(text);
    }

    void writeModels() {
        ByteWriter& to = out(svo::MODL);
        for (const SvoModel& model : file_.models) {
            const Octree& octree = model.octree;
            to.u32(static_cast<std::uint32_t>(nodeCount_));
            to.u32(static_cast<std::uint32_t>(payloadCount_));
            to.u32(static_cast<std::uint32_t>(octree.maxDepth));
            for (int axis = 0; axis < 3; ++axis) {
                to.u32(static_cast<std::uint32_t>(octree.size[axis]));
            }
            to.u32(static_cast<std::uint32_t>(octree.nodes.size()));
            to.u32(static_cast<std::uint32_t>(octree.payloads.size()));
            for (int axis = 0; axis < 3; ++axis) to.i32(octree.origin[axis]);
            writeText(to, model.name);
            to.alignTo(64);
            out(svo::NODE).raw(asBytes(octree.nodes));
            out(svo::PAYL).raw(asBytes(octree.payloads));
            nodeCount_ += octree.nodes.size();
            payloadCount_ += octree.payloads.size();
        }
    }

    void writeColour(ByteWriter& to, Rgba8 colour) {
        for (int channel = 0; channel < 4; ++channel) to.u8(colour[channel]);
    }

    void writePalette() {
        for (const Rgba8 colour : file_.palette) writeColour(out(svo::PALT), colour);
        for (const std::string& name : file_.colourNames) writeText(out(svo::CNAM), name);
    }

    void writeClips() {
        ByteWriter& to = out(svo::CLIP);
        ByteWriter& frames = out(svo::FRAM);
        for (const SvoClip& clip : file_.clips) {
            writeText(to, clip.name);
            to.u32(static_cast<std::uint32_t>(frames.size() / 8));
            to.u32(static_cast<std::uint32_t>(clip.models.size()));
            to.u32(clip.loop ? 1 : 0);
            to.alignTo(32);
            for (std::size_t i = 0; i < clip.models.size(); ++i) {
                frames.u32(clip.models[i]);
                frames.u32(clip.durationsMilliseconds[i]);
            }
        }
    }

    void writeAuthored() {
        ByteWriter& to = out(svo::AUTH);
        to.f64(file_.voxelSizeMetres);
        to.f64(file_.sigma);
        for (int axis = 0; axis < 3; ++axis) to.f64(file_.anchor[axis]);
        to.u32(file_.outline.enabled ? 1 : 0);
        writeColour(to, file_.outline.colour);
        writeText(to, file_.name);
        to.alignTo(64);
    }

    void writeSockets() {
        ByteWriter& to = out(svo::SOCK);
        ByteWriter& positions = out(svo::SPOS);
        for (const SvoSocket& socket : file_.sockets) {
            writeText(to, socket.name);
            to.u32(static_cast<std::uint32_t>(positions.size() / 24));
            to.u32(static_cast<std::uint32_t>(socket.positions.size()));
            for (const glm::dvec3& position : socket.positions) {
                for (int axis = 0; axis < 3; ++axis) positions.f64(position[axis]);
            }
        }
    }

    // How many sections there are; the optional ones stand at the end.
    [[nodiscard]] std::size_t sectionCount() const {
        return file_.sockets.empty() ? svo::kRequired : svo::kSections;
    }

    [[nodiscard]] Bytes assemble() const {
        const auto aligned = [](std::uint64_t offset) {
            return (offset + svo::kAlignment - 1) / svo::kAlignment * svo::kAlignment;
        };
        const std::span sections(sections_.data(), sectionCount());
        const std::uint64_t tableEnd =
            svo::kHeaderBytes + svo::kSectionEntryBytes * sections.size();
        std::uint64_t end = tableEnd;
        for (const ByteWriter& section : sections) end = aligned(end) + section.size();

        ByteWriter to;
        to.raw(svo::kMagic);
        to.u16(svo::kMajorVersion);
        to.u16(file_.sockets.empty() ? 0 : svo::kMinorOfSockets);
        to.u32(static_cast<std::uint32_t>(sections.size()));
        to.u64(end);
        to.alignTo(svo::kHeaderBytes);
        end = tableEnd;
        for (std::size_t i = 0; i < sections.size(); ++i) {
            const ByteWriter& section = sections[i];
            to.raw(svo::kLayouts[i].tag);
            to.u32(i < svo::kRequired ? svo::kMustKnow : 0);
            to.u64(aligned(end));
            to.u64(section.size());
            to.u32(crc32(section.bytes()));
            to.u32(0);
            end = aligned(end) + section.size();
        }
        to.patchU32(svo::kHeaderCrcAt, svo::headerCrc(to.bytes()));
        for (const ByteWriter& section : sections) {
            to.alignTo(svo::kAlignment);
            to.raw(section.bytes());
        }
        return to.release();
    }

    const SvoFile& file_;
    std::array<ByteWriter, svo::kSections> sections_;
    std::uint64_t nodeCount_ = 0;
    std::uint64_t payloadCount_ = 0;
};

}  // namespace

Result<Bytes> writeSvo(const SvoFile& file) {
    return SvoWriter(file).run();
}

}  // namespace voxprite
