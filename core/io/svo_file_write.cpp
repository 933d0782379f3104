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
    explicit SvoWriter(std::span<const SvoFile> entities) : entities_(entities) {}

    Result<Bytes> run() {
        if (Status s = check(); !s) return tl::unexpected(s.error());
        for (const SvoFile& entity : entities_) write(entity);
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
        for (const SvoFile& entity : entities_) {
            if (Status s = check(entity); !s) return s;
        }
        return svo::checkLimits(entities_);
    }

    [[nodiscard]] static Status check(const SvoFile& file) {
        for (const SvoModel& model : file.models) {
            if (Status s = svo::checkModel(model); !s) return s;
        }
        for (const SvoClip& clip : file.clips) {
            if (Status s = svo::checkClip(clip, file.models); !s) return s;
        }
        for (const SvoSocket& socket : file.sockets) {
            if (Status s = svo::checkSocket(socket, file); !s) return s;
        }
        for (const std::string& name : file.colourNames) {
            if (Status s = svo::checkText(name); !s) return s;
        }
        return svo::checkValues(file);
    }

    // Indices and offsets of a later entity count from the file's beginning, as those of its first.
    void write(const SvoFile& file) {
        writeEntity(file);
        writeModels(file);
        writePalette(file);
        writeClips(file);
        writeAuthored(file);
        writeSockets(file);
    }

    [[nodiscard]] std::uint32_t recordsOf(svo::Section section) const {
        return static_cast<std::uint32_t>(sections_[section].size() /
                                          svo::kLayouts[section].recordBytes);
    }

    void writeEntity(const SvoFile& file) {
        ByteWriter& to = out(svo::ENTY);
        firstModel_ = recordsOf(svo::MODL);
        to.u32(firstModel_);
        to.u32(static_cast<std::uint32_t>(file.models.size()));
        to.u32(recordsOf(svo::CLIP));
        to.u32(static_cast<std::uint32_t>(file.clips.size()));
        to.u32(recordsOf(svo::SOCK));
        to.u32(static_cast<std::uint32_t>(file.sockets.size()));
        to.alignTo(32);
    }

    void writeText(ByteWriter& to, const std::string& text) {
        ByteWriter& texts = out(svo::STRS);
        to.u32(text.empty() ? 0 : static_cast<std::uint32_t>(texts.size()));
        to.u32(static_cast<std::uint32_t>(text.size()));
        texts.raw(text);
    }

    void writeModels(const SvoFile& file) {
        ByteWriter& to = out(svo::MODL);
        for (const SvoModel& model : file.models) {
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

    void writePalette(const SvoFile& file) {
        for (const Rgba8 colour : file.palette) writeColour(out(svo::PALT), colour);
        for (const std::string& name : file.colourNames) writeText(out(svo::CNAM), name);
    }

    void writeClips(const SvoFile& file) {
        ByteWriter& to = out(svo::CLIP);
        ByteWriter& frames = out(svo::FRAM);
        for (const SvoClip& clip : file.clips) {
            writeText(to, clip.name);
            to.u32(static_cast<std::uint32_t>(frames.size() / 8));
            to.u32(static_cast<std::uint32_t>(clip.models.size()));
            to.u32(clip.loop ? 1 : 0);
            to.alignTo(32);
            for (std::size_t i = 0; i < clip.models.size(); ++i) {
                frames.u32(firstModel_ + clip.models[i]);
                frames.u32(clip.durationsMilliseconds[i]);
            }
        }
    }

    void writeAuthored(const SvoFile& file) {
        ByteWriter& to = out(svo::AUTH);
        to.f64(file.voxelSizeMetres);
        to.f64(file.sigma);
        for (int axis = 0; axis < 3; ++axis) to.f64(file.anchor[axis]);
        to.u32(file.outline.enabled ? 1 : 0);
        writeColour(to, file.outline.colour);
        writeText(to, file.name);
        to.alignTo(64);
    }

    void writeSockets(const SvoFile& file) {
        ByteWriter& to = out(svo::SOCK);
        ByteWriter& positions = out(svo::SPOS);
        for (const SvoSocket& socket : file.sockets) {
            writeText(to, socket.name);
            to.u32(static_cast<std::uint32_t>(positions.size() / 24));
            to.u32(static_cast<std::uint32_t>(socket.positions.size()));
            for (const glm::dvec3& position : socket.positions) {
                for (int axis = 0; axis < 3; ++axis) positions.f64(position[axis]);
            }
        }
    }

    // Those that the file needs, in their order; the optional ones stand at the end.
    [[nodiscard]] std::vector<svo::Section> sectionsNeeded() const {
        std::vector<svo::Section> needed;
        for (std::size_t i = 0; i < svo::kSections; ++i) {
            const auto section = static_cast<svo::Section>(i);
            const bool ofSockets = section == svo::SOCK || section == svo::SPOS;
            if (ofSockets && sections_[svo::SOCK].size() == 0) continue;
            if (section == svo::ENTY && entities_.size() == 1) continue;
            needed.push_back(section);
        }
        return needed;
    }

    // The least that has what the file holds.
    [[nodiscard]] std::uint16_t minorVersion() const {
        if (entities_.size() > 1) return svo::kMinorOfSets;
        return sections_[svo::SOCK].size() == 0 ? 0 : svo::kMinorOfSockets;
    }

    // Who does not know of entities would take all for one.
    [[nodiscard]] static bool mustKnow(svo::Section section) {
        return section < svo::kRequired || section == svo::ENTY;
    }

    [[nodiscard]] Bytes assemble() const {
        const auto aligned = [](std::uint64_t offset) {
            return (offset + svo::kAlignment - 1) / svo::kAlignment * svo::kAlignment;
        };
        const std::vector<svo::Section> needed = sectionsNeeded();
        const std::uint64_t tableEnd = svo::kHeaderBytes + svo::kSectionEntryBytes * needed.size();
        std::uint64_t end = tableEnd;
        for (const svo::Section section : needed) end = aligned(end) + sections_[section].size();

        ByteWriter to;
        to.raw(svo::kMagic);
        to.u16(svo::kMajorVersion);
        to.u16(minorVersion());
        to.u32(static_cast<std::uint32_t>(needed.size()));
        to.u64(end);
        to.alignTo(svo::kHeaderBytes);
        end = tableEnd;
        for (const svo::Section section : needed) {
            const ByteWriter& part = sections_[section];
            to.raw(svo::kLayouts[section].tag);
            to.u32(mustKnow(section) ? svo::kMustKnow : 0);
            to.u64(aligned(end));
            to.u64(part.size());
            to.u32(crc32(part.bytes()));
            to.u32(0);
            end = aligned(end) + part.size();
        }
        to.patchU32(svo::kHeaderCrcAt, svo::headerCrc(to.bytes()));
        for (const svo::Section section : needed) {
            to.alignTo(svo::kAlignment);
            to.raw(sections_[section].bytes());
        }
        return to.release();
    }

    std::span<const SvoFile> entities_;
    std::array<ByteWriter, svo::kSections> sections_;
    std::uint32_t firstModel_ = 0;  // of the entity being written
    std::uint64_t nodeCount_ = 0;
    std::uint64_t payloadCount_ = 0;
};

}  // namespace

Result<Bytes> writeSvo(const SvoFile& file) {
    return SvoWriter({&file, 1}).run();
}

Result<Bytes> writeSvoSet(std::span<const SvoFile> entities) {
    return SvoWriter(entities).run();
}

}  // namespace voxprite
