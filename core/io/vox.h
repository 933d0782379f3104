// MagicaVoxel .vox, versions 150 and 200, with the scene graph extension.
//
// Format: github.com/ephtracy/voxel-model (the base format and its extension), and what real files
// do where it is silent:
//
// Models      A model's pivot is floor(size / 2) and becomes the origin of its model space: voxel v
//             of the file is v - floor(size / 2) here, and canvas.min is -floor(size / 2). Of two
//             voxels in one place the later counts; colour 0 is left out, and so, with a warning,
//             is a voxel outside its SIZE. MagicaVoxel's sizes end at 256; up to 2048 are read
//             (positions are bytes all the same). A size of 0 counts as 1. Models without voxels
//             are kept.
// Placement   A transform turns cells about the pivot as continuous space, so that a mirrored axis
//             sends cell v to -v - 1 and parts of odd and even sizes meet.
// Scene       A transform and the group or shape below it are one SceneNode, named by the
//             transform. Nodes that the file shares are copied for each use. Without a scene graph
//             there is one object whose pivot is over the origin and whose bottom is at z = 0, as
//             MagicaVoxel places what it opens; several models are frames of its animation, which
//             is what PACK was for.
// Animation   _f of a transform's frames and of a shape's models are the keys' frames (an entry
//             without one: its position in the list). Objects glide from key to key and turn at
//             them, models change at their keys; _loop "1" repeats the track from its first key to
//             its last (so has it ogt_vox, github.com/jpaver/opengametools, which cuts places
//             between toward zero; here they are rounded down). Tracks that hold still until the
//             next key are written with a key more.
// Layers      by their id; ids that are missing become blank layers. Where there are layers an
//             object on none is written onto the first that is not hidden: readers rely on it.
// Colours     RGBA entry i is colour i + 1. A short chunk fills the colours that it has; none means
//             the default palette. IMAP entry k is the colour shown in slot k + 1: it becomes
//             Palette::displayOrder and never changes an index. NOTE names rows of eight slots,
//             the last row first; each colour of the row gets the name.
// Materials   MATL; the older MATT becomes the MATL properties of the same meaning.
// Kept        rCAM, rOBJ, and attributes that are not understood. Those of a node's other places
//             carry them in their key: "group/K", "shape/K", "frame/I/K" and "model/I/K" with I the
//             index of the key frame. Text that is not UTF-8 is taken as Latin-1.
// Skipped     META and chunks of unknown kind, by their length, with a warning.
//
// Two things are written that the format does not have, where other readers pass over them: the
// attribute _locked "1" of a transform, and, only where single colours of a row have names of their
// own, a chunk "vpCN" (count, then a byte for the index and a string each).
#pragma once

#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/model/document.h"

namespace voxprite {

struct VoxImport {
    Document document;
    std::vector<std::string> warnings;  // what was odd but harmless, one sentence each
};

// All or nothing. Fails with the byte offset on anything that is not a .vox, is cut short, refers
// to what is not there, contains itself, is nested deeper than 2048 nodes, or would take too much
// memory: besides a small multiple of the file's length, copies of shared nodes may take 64 MiB and
// the blocks of the voxel grids (OpenVDB stores 8 x 8 x 8 voxels even for one) 1 GiB.
[[nodiscard]] Result<VoxImport> readVox(ByteView bytes);

// Version 200 with scene graph, layers, materials, palette order and animation, within
// MagicaVoxel's own rules.
//
// Reads back equal if every model has a canvas of at most 256 on an edge that holds its voxels and
// starts at -floor(size / 2) and, where there are layers, every object lies on one, as in all
// documents from MagicaVoxel, except for what .vox has no words for: clips, sockets, the entity's
// settings, authored values, ids of render settings, and the keys that hold an object still. A
// canvas that does not fit is replaced by the smallest that does; models too far from their origin
// for one get another pivot, models longer than 256 are cut into cubes of 256 under a group. All
// frames of the entity stay the same.
//
// Fails on an invalid document, on more than 1024 layers, nesting too deep to be read again, and
// more voxels than a file can hold.
[[nodiscard]] Result<Bytes> writeVox(const Document& document);
// What is lost beside what the format has no words for: models that are cut.
[[nodiscard]] std::vector<std::string> voxLosses(const Document& document);

}  // namespace voxprite
