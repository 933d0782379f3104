// Code points of the icon font (Material Design Icons 1.6) as UTF-8.
#pragma once

namespace voxprite::editor::icon {

inline constexpr char32_t kFirst = 0xF001;
inline constexpr char32_t kLast = 0xF6FF;

inline constexpr const char* kAttach = "\uF3EB";
inline constexpr const char* kErase = "\uF1FE";
inline constexpr const char* kPaint = "\uF27C";
inline constexpr const char* kBrush = "\uF0E3";
inline constexpr const char* kFace = "\uF060";
inline constexpr const char* kLaser = "\uF241";
inline constexpr const char* kFill = "\uF266";
inline constexpr const char* kPlaneFill = "\uF50C";
inline constexpr const char* kStamp = "\uF192";
inline constexpr const char* kLine = "\uF55E";
inline constexpr const char* kSphere = "\uF12F";
inline constexpr const char* kEllipse = "\uF556";
inline constexpr const char* kCylinder = "\uF1B8";
inline constexpr const char* kSelectBox = "\uF562";
inline constexpr const char* kSelectRectangle = "\uF485";
inline constexpr const char* kWand = "\uF068";
inline constexpr const char* kSocket = "\uF34E";
inline constexpr const char* kBox = "\uF1A6";
inline constexpr const char* kPickColour = "\uF20A";
inline constexpr const char* kPickAnchor = "\uF4FE";
inline constexpr const char* kMove = "\uF1B6";
inline constexpr const char* kRotate = "\uF464";
inline constexpr const char* kScale = "\uF616";
inline constexpr const char* kAnchor = "\uF031";
inline constexpr const char* kWireframe = "\uF1A7";
inline constexpr const char* kGrid = "\uF2C1";
inline constexpr const char* kLink = "\uF339";
inline constexpr const char* kUnlink = "\uF338";
inline constexpr const char* kVisible = "\uF208";
inline constexpr const char* kHidden = "\uF209";
inline constexpr const char* kLocked = "\uF33E";
inline constexpr const char* kUnlocked = "\uF33F";
inline constexpr const char* kFit = "\uF2F1";
inline constexpr const char* kUndo = "\uF54C";
inline constexpr const char* kRedo = "\uF44E";
inline constexpr const char* kFolder = "\uF24B";
inline constexpr const char* kFile = "\uF224";
inline constexpr const char* kSave = "\uF193";
inline constexpr const char* kOpen = "\uF256";
inline constexpr const char* kExport = "\uF1A8";
inline constexpr const char* kClose = "\uF156";
inline constexpr const char* kCheck = "\uF12C";
inline constexpr const char* kPlus = "\uF415";
inline constexpr const char* kMinus = "\uF374";
inline constexpr const char* kDelete = "\uF1C0";
inline constexpr const char* kWarning = "\uF026";
inline constexpr const char* kInfo = "\uF2FD";
inline constexpr const char* kDark = "\uF594";
inline constexpr const char* kLight = "\uF599";
inline constexpr const char* kUp = "\uF05D";
inline constexpr const char* kHome = "\uF2DC";
inline constexpr const char* kPlay = "\uF40A";
inline constexpr const char* kPause = "\uF3E4";
inline constexpr const char* kRight = "\uF142";
inline constexpr const char* kDown = "\uF140";
inline constexpr const char* kLayers = "\uF328";
inline constexpr const char* kPalette = "\uF3D8";
inline constexpr const char* kHistory = "\uF2DA";
inline constexpr const char* kReset = "\uF450";
inline constexpr const char* kSearch = "\uF349";
inline constexpr const char* kCopy = "\uF18F";
inline constexpr const char* kKeyboard = "\uF30C";
inline constexpr const char* kSettings = "\uF493";
inline constexpr const char* kHelp = "\uF625";
inline constexpr const char* kCamera = "\uF567";
inline constexpr const char* kPerspective = "\uF1A7";
inline constexpr const char* kIsometric = "\uF2D9";

inline constexpr const char* kTwoCells = "\uF56A";
inline constexpr const char* kFourCells = "\uF570";
inline constexpr const char* kPicture = "\uF2E9";
inline constexpr const char* kPeople = "\uF00E";
inline constexpr const char* kDice = "\uF1CE";

}  // namespace voxprite::editor::icon
