#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>

#include "core/base/hash.h"
#include "core/io/svo_file_format.h"

namespace voxprite {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays are read as they stand");

// Reads fields in a row; the first failure sticks, later reads give 0.
class Fields {
  public:
    Fields(ByteReader reader, std::string_view what) : reader_(reader), what_(what) {}

    [[nodiscard]] std::uint16_t u16() { return kept(reader_.u16(what_)); }
    [[nodiscard]] std::uint32_t u32() { return kept(reader_.u32(what_)); }
    [[nodiscard]] std::uint64_t u64() { return kept(reader_.u64(what_)); }
    [[nodiscard]] std::int32_t i32() { return kept(reader_.i32(what_)); }
    [[nodiscard]] double f64() { return kept(reader_.f64(what_)); }
    [[nodiscard]] ByteView take(std::uint64_t count) { return kept(reader_.take(count, what_)); }
    void skip(std::uint64_t count) { static_cast<void>(take(count)); }
    [[nodiscard]] Rgba8 colour() {
        const ByteView rgba = take(4);
        return rgba.empty() ? Rgba8(0) : Rgba8(rgba[0], rgba[1], rgba[2], rgba[3]);
    }
    [[nodiscard]] std::uint64_t offset() const { return reader_.offset(); }
    [[nodiscard]] Status status() const {
        if (error_) return tl::unexpected(*error_);
        return {};
    }

  private:
    template <class T>
    T kept(Result<T> value) {
        if (value) return *value;
        if (!error_) error_ = value.error();
        return T{};
    }

    ByteReader reader_;
    std::string_view what_;
    std::optional<Error> error_;
};

Status atByte(std::uint64_t offset, Status status) {
    if (!status) status.error().offset = offset;
    return status;
}

class SvoReader {
  public:
    explicit SvoReader(ByteView bytes) : bytes_(bytes) {}

    Result<std::vector<SvoFile>> run() {
        for (const auto step :
             {&SvoReader::readHeader, &SvoReader::readTable, &SvoReader::checkSections,
              &SvoReader::readEntities, &SvoReader::readModels, &SvoReader::readPalettes,
              &SvoReader::readClips, &SvoReader::readAuthored, &SvoReader::readSockets}) {
            if (Status s = (this->*step)(); !s) return tl::unexpected(s.error());
        }
        if (Status s = svo::checkLimits(entities_); !s) {
            return failAtByte(at(svo::MODL), s.error().message);
        }
        return std::move(entities_);
    }

  private:
    struct Part {
        std::uint64_t offset = 0;
        std::uint64_t length = 0;
        bool present = false;
    };
    // What of the file belongs to an entity.
    struct Shares {
        std::uint32_t firstModel = 0;
        std::uint64_t models = 0;
        std::uint64_t clips = 0;
        std::uint64_t sockets = 0;
    };

    [[nodiscard]] std::uint64_t at(svo::Section section) const { return parts_[section].offset; }
    [[nodiscard]] ByteView bytesOf(const Part& part) const {
        return bytes_.subspan(part.offset, part.length);
    }
    [[nodiscard]] Fields fieldsOf(svo::Section section) const {
        return {ByteReader(bytesOf(parts_[section]), at(section)), svo::kLayouts[section].tag};
    }
    [[nodiscard]] std::uint64_t recordsOf(svo::Section section) const {
        return parts_[section].length / svo::kLayouts[section].recordBytes;
    }

    [[nodiscard]] Status readHeader() {
        Fields fields(ByteReader(bytes_), "the header");
        const ByteView magic = fields.take(svo::kMagic.size());
        if (!std::equal(magic.begin(), magic.end(), svo::kMagic.begin(), svo::kMagic.end())) {
            return failAtByte(0, "this is not a .svo file");
        }
        const std::uint16_t major = fields.u16();
        static_cast<void>(fields.u16());
        sectionCount_ = fields.u32();
        const std::uint64_t length = fields.u64();
        fields.skip(svo::kHeaderCrcAt - 24);
        const std::uint32_t crc = fields.u32();
        if (Status s = fields.status(); !s) return s;
        if (major != svo::kMajorVersion) {
            return failAtByte(8, "version " + std::to_string(major) + " of .svo is not known");
        }
        if (length != bytes_.size()) {
            return failAtByte(16, "the file should have " + std::to_string(length) +
                                      " bytes and has " + std::to_string(bytes_.size()));
        }
        if (sectionCount_ > (bytes_.size() - svo::kHeaderBytes) / svo::kSectionEntryBytes) {
            return failAtByte(12, "the section table is longer than the file");
        }
        if (kChecksumsCount && crc != svo::headerCrc(bytes_.first(tableEnd()))) {
            return failAtByte(svo::kHeaderCrcAt, "the header or section table is damaged");
        }
        return {};
    }

    [[nodiscard]] std::uint64_t tableEnd() const {
        return svo::kHeaderBytes + svo::kSectionEntryBytes * std::uint64_t{sectionCount_};
    }

    [[nodiscard]] Status readTable() {
        ByteReader table(bytes_.subspan(svo::kHeaderBytes, tableEnd() - svo::kHeaderBytes),
                         svo::kHeaderBytes);
        Fields fields(table, "the section table");
        std::uint64_t end = tableEnd();
        for (std::uint32_t i = 0; i < sectionCount_; ++i) {
            const std::uint64_t entry = fields.offset();
            const ByteView tag = fields.take(4);
            const std::uint32_t flags = fields.u32();
            Part part;
            part.offset = fields.u64();
            part.length = fields.u64();
            part.present = true;
            const std::uint32_t crc = fields.u32();
            fields.skip(4);
            const std::string name(tag.begin(), tag.end());
            if (part.offset % svo::kAlignment != 0 || part.offset < end ||
                part.offset > bytes_.size() || part.length > bytes_.size() - part.offset) {
                return failAtByte(entry, "section " + name + " does not lie within the file");
            }
            end = part.offset + part.length;
            if (kChecksumsCount && crc != crc32(bytesOf(part))) {
                return failAtByte(part.offset, "section " + name + " is damaged");
            }
            const auto layout =
                std::find_if(svo::kLayouts.begin(), svo::kLayouts.end(),
                             [&](const svo::SectionLayout& known) { return known.tag == name; });
            if (layout != svo::kLayouts.end()) {
                Part& known = parts_[static_cast<std::size_t>(layout - svo::kLayouts.begin())];
                if (known.present) return failAtByte(entry, "section " + name + " occurs twice");
                known = part;
            } else if ((flags & svo::kMustKnow) != 0) {
                return failAtByte(entry, "section " + name + " is not known, but must be");
            }
        }
        return fields.status();
    }

    [[nodiscard]] Status checkSections() {
        for (std::size_t i = 0; i < svo::kSections; ++i) {
            const svo::SectionLayout& layout = svo::kLayouts[i];
            const std::string name = "section " + std::string(layout.tag);
            const Part& part = parts_[i];
            if (!part.present && i >= svo::kRequired) continue;
            if (!part.present) return failAtByte(svo::kHeaderBytes, name + " is missing");
            if (part.length % layout.recordBytes != 0 ||
                (layout.records != 0 &&
                 part.length != layout.recordBytes * layout.records * entityCount())) {
                return failAtByte(part.offset, name + " has a wrong length");
            }
        }
        return {};
    }

    // One where the file says nothing of entities.
    [[nodiscard]] std::uint64_t entityCount() const {
        return parts_[svo::ENTY].present ? recordsOf(svo::ENTY) : 1;
    }

    [[nodiscard]] Status readEntities() {
        if (!parts_[svo::ENTY].present) {
            entities_.resize(1);
            shares_ = {{0, recordsOf(svo::MODL), recordsOf(svo::CLIP), recordsOf(svo::SOCK)}};
            return {};
        }
        if (entityCount() < 2 || entityCount() > svo::kMaxEntities) {
            return failAtByte(at(svo::ENTY), "a set has 2 ... 4,096 entities, not " +
                                                 std::to_string(entityCount()));
        }
        entities_.resize(entityCount());
        Fields fields = fieldsOf(svo::ENTY);
        std::array<std::uint64_t, 3> ends{};
        for (std::uint64_t i = 0; i < entityCount(); ++i) {
            std::array<std::uint32_t, 3> counts{};
            Shares shares;
            shares.firstModel = static_cast<std::uint32_t>(ends[0]);
            for (std::size_t k = 0; k < counts.size(); ++k) {
                const svo::Section section = std::array{svo::MODL, svo::CLIP, svo::SOCK}[k];
                const std::uint64_t entry = fields.offset();
                const std::uint32_t first = fields.u32();
                counts[k] = fields.u32();
                if (first != ends[k] || counts[k] > recordsOf(section) - ends[k]) {
                    return failAtByte(entry, "the entity's part of " +
                                                 std::string(svo::kLayouts[section].tag) +
                                                 " is not the next one");
                }
                ends[k] += counts[k];
            }
            if (counts[0] == 0) return failAtByte(fields.offset() - 20, "an entity without models");
            fields.skip(8);
            shares.models = counts[0];
            shares.clips = counts[1];
            shares.sockets = counts[2];
            shares_.push_back(shares);
        }
        if (ends[0] != recordsOf(svo::MODL) || ends[1] != recordsOf(svo::CLIP) ||
            ends[2] != recordsOf(svo::SOCK)) {
            return failAtByte(at(svo::ENTY), "models, clips or sockets that belong to no entity");
        }
        return fields.status();
    }

    // A text of a record. Texts share no bytes, so together they are no longer than STRS.
    [[nodiscard]] Status readText(Fields& fields, std::string& text) {
        const std::uint64_t entry = fields.offset();
        const std::uint64_t first = fields.u32();
        const std::uint64_t length = fields.u32();
        const ByteView texts = bytesOf(parts_[svo::STRS]);
        textBytes_ += length;
        if (first + length > texts.size() || textBytes_ > texts.size()) {
            return failAtByte(entry, "a text does not lie within section STRS");
        }
        const ByteView part = texts.subspan(first, length);
        text.assign(part.begin(), part.end());
        return atByte(at(svo::STRS) + first, svo::checkText(text));
    }

    // The next `count` elements of an array that lie at `first`, where the ones before ended.
    template <class T>
    [[nodiscard]] Status readArray(svo::Section section, std::uint64_t record, std::uint64_t first,
                                   std::uint64_t count, std::uint64_t& end, std::vector<T>& to) {
        const std::string name(svo::kLayouts[section].tag);
        if (first != end)
            return failAtByte(record, "the model's part of " + name + " leaves a gap");
        if (count > recordsOf(section) - first) {
            return failAtByte(record, "the model's part of " + name + " ends beyond it");
        }
        end += count;
        to.resize(count);
        const ByteView part =
            bytesOf(parts_[section]).subspan(first * sizeof(T), count * sizeof(T));
        if (!part.empty()) std::memcpy(to.data(), part.data(), part.size());
        return {};
    }

    [[nodiscard]] Status readModels() {
        Fields fields = fieldsOf(svo::MODL);
        std::uint64_t nodesEnd = 0;
        std::uint64_t payloadsEnd = 0;
        for (std::size_t e = 0; e < entities_.size(); ++e) {
            for (std::uint64_t i = 0; i < shares_[e].models; ++i) {
                const std::uint64_t record = fields.offset();
                SvoModel model;
                Octree& octree = model.octree;
                const std::uint32_t firstNode = fields.u32();
                const std::uint32_t firstPayload = fields.u32();
                octree.maxDepth = fields.i32();
                for (int axis = 0; axis < 3; ++axis) octree.size[axis] = fields.i32();
                const std::uint32_t nodes = fields.u32();
                const std::uint32_t payloads = fields.u32();
                for (int axis = 0; axis < 3; ++axis) octree.origin[axis] = fields.i32();
                if (Status s = readText(fields, model.name); !s) return s;
                fields.skip(12);
                if (Status s =
                        readArray(svo::NODE, record, firstNode, nodes, nodesEnd, octree.nodes);
                    !s) {
                    return s;
                }
                if (Status s = readArray(svo::PAYL, record + 4, firstPayload, payloads, payloadsEnd,
                                         octree.payloads);
                    !s) {
                    return s;
                }
                if (Status s = svo::checkModel(model); !s) {
                    const std::optional<std::uint64_t> node = s.error().offset;
                    return atByte(node ? at(svo::NODE) + 4 * (firstNode + *node) : record, s);
                }
                entities_[e].models.push_back(std::move(model));
            }
        }
        if (nodesEnd != recordsOf(svo::NODE)) {
            return failAtByte(at(svo::NODE) + 4 * nodesEnd, "nodes that belong to no model");
        }
        if (payloadsEnd != recordsOf(svo::PAYL)) {
            return failAtByte(at(svo::PAYL) + 8 * payloadsEnd, "payloads that belong to no model");
        }
        return fields.status();
    }

    [[nodiscard]] Status readPalettes() {
        Fields colours = fieldsOf(svo::PALT);
        Fields names = fieldsOf(svo::CNAM);
        for (SvoFile& entity : entities_) {
            for (Rgba8& colour : entity.palette) colour = colours.colour();
            for (std::string& name : entity.colourNames) {
                if (Status s = readText(names, name); !s) return s;
            }
        }
        if (Status s = colours.status(); !s) return s;
        return names.status();
    }

    [[nodiscard]] Status readClips() {
        Fields fields = fieldsOf(svo::CLIP);
        Fields frames = fieldsOf(svo::FRAM);
        std::uint64_t framesEnd = 0;
        for (std::size_t e = 0; e < entities_.size(); ++e) {
            for (std::uint64_t i = 0; i < shares_[e].clips; ++i) {
                if (Status s = readClip(fields, frames, framesEnd, e); !s) return s;
            }
        }
        if (framesEnd != recordsOf(svo::FRAM)) {
            return failAtByte(at(svo::FRAM) + 8 * framesEnd, "frames that belong to no clip");
        }
        if (Status s = fields.status(); !s) return s;
        return frames.status();
    }

    [[nodiscard]] Status readClip(Fields& fields, Fields& frames, std::uint64_t& framesEnd,
                                  std::size_t entity) {
        const std::uint64_t record = fields.offset();
        SvoClip clip;
        if (Status s = readText(fields, clip.name); !s) return s;
        const std::uint32_t first = fields.u32();
        const std::uint32_t count = fields.u32();
        clip.loop = (fields.u32() & 1) != 0;
        fields.skip(12);
        if (first != framesEnd || count > recordsOf(svo::FRAM) - framesEnd) {
            return failAtByte(record + 8, "the clip's frames are not the next ones of FRAM");
        }
        framesEnd += count;
        for (std::uint32_t frame = 0; frame < count; ++frame) {
            // Models count from the file's first.
            const std::uint32_t model = frames.u32();
            if (model < shares_[entity].firstModel) {
                return failAtByte(frames.offset() - 4, "a clip shows another entity's model");
            }
            clip.models.push_back(model - shares_[entity].firstModel);
            clip.durationsMilliseconds.push_back(frames.u32());
        }
        if (Status s = svo::checkClip(clip, entities_[entity].models); !s) {
            return atByte(record, s);
        }
        entities_[entity].clips.push_back(std::move(clip));
        return {};
    }

    [[nodiscard]] Status readAuthored() {
        Fields fields = fieldsOf(svo::AUTH);
        for (SvoFile& entity : entities_) {
            const std::uint64_t record = fields.offset();
            entity.voxelSizeMetres = fields.f64();
            entity.sigma = fields.f64();
            for (int axis = 0; axis < 3; ++axis) entity.anchor[axis] = fields.f64();
            entity.outline.enabled = (fields.u32() & 1) != 0;
            entity.outline.colour = fields.colour();
            if (Status s = readText(fields, entity.name); !s) return s;
            fields.skip(8);
            if (Status s = fields.status(); !s) return s;
            if (Status s = atByte(record, svo::checkValues(entity)); !s) return s;
        }
        return {};
    }

    [[nodiscard]] Status readSockets() {
        if (parts_[svo::SOCK].present != parts_[svo::SPOS].present) {
            return failAtByte(svo::kHeaderBytes, "of SOCK and SPOS there is only one");
        }
        Fields fields = fieldsOf(svo::SOCK);
        Fields positions = fieldsOf(svo::SPOS);
        std::uint64_t positionsEnd = 0;
        for (std::size_t e = 0; e < entities_.size(); ++e) {
            for (std::uint64_t i = 0; i < shares_[e].sockets; ++i) {
                if (Status s = readSocket(fields, positions, positionsEnd, entities_[e]); !s) {
                    return s;
                }
            }
        }
        if (positionsEnd != recordsOf(svo::SPOS)) {
            return failAtByte(at(svo::SPOS) + 24 * positionsEnd,
                              "positions that belong to no socket");
        }
        if (Status s = fields.status(); !s) return s;
        return positions.status();
    }

    [[nodiscard]] Status readSocket(Fields& fields, Fields& positions, std::uint64_t& positionsEnd,
                                    SvoFile& entity) {
        const std::uint64_t record = fields.offset();
        SvoSocket socket;
        if (Status s = readText(fields, socket.name); !s) return s;
        const std::uint32_t first = fields.u32();
        const std::uint32_t count = fields.u32();
        if (first != positionsEnd || count > recordsOf(svo::SPOS) - positionsEnd) {
            return failAtByte(record + 8, "the socket's positions are not the next of SPOS");
        }
        positionsEnd += count;
        for (std::uint32_t k = 0; k < count; ++k) {
            glm::dvec3& position = socket.positions.emplace_back();
            for (int axis = 0; axis < 3; ++axis) position[axis] = positions.f64();
        }
        if (Status s = svo::checkSocket(socket, entity); !s) return atByte(record, s);
        entity.sockets.push_back(std::move(socket));
        return {};
    }

    ByteView bytes_;
    std::uint32_t sectionCount_ = 0;
    std::array<Part, svo::kSections> parts_;
    std::uint64_t textBytes_ = 0;
    std::vector<Shares> shares_;  // one an entity
    std::vector<SvoFile> entities_;
};

// "3 entities (0 knight, 1 oak, 2 truck)".
std::string listedEntities(const std::vector<SvoFile>& set) {
    constexpr std::size_t kNamed = 16;
    std::string list = std::to_string(set.size()) + (set.size() == 1 ? " entity (" : " entities (");
    for (std::size_t i = 0; i < std::min(set.size(), kNamed); ++i) {
        list += (i == 0 ? "" : ", ") + std::to_string(i) + (set[i].name.empty() ? "" : " ") +
                set[i].name;
    }
    return list + (set.size() > kNamed ? ", ...)" : ")");
}

}  // namespace

Result<std::vector<SvoFile>> readSvoSet(ByteView bytes) {
    return SvoReader(bytes).run();
}

Result<SvoFile> readSvo(ByteView bytes, std::optional<std::size_t> entity) {
    Result<std::vector<SvoFile>> set = readSvoSet(bytes);
    if (!set) return Failure(set.error());
    if (!entity && set->size() > 1)
        return fail("the file holds " + listedEntities(*set) + "; one must be chosen");
    const std::size_t chosen = entity.value_or(0);
    if (chosen >= set->size())
        return fail("there is no entity " + std::to_string(chosen) + "; the file holds " +
                    listedEntities(*set));
    return std::move((*set)[chosen]);
}

}  // namespace voxprite
