#pragma once

#include <string>
#include <string_view>

#include "carom/result.hpp"

/// The outer form of texts for links (docs/formats.md): base64url of a version, a checksum and the
/// packed payload.
namespace replay {

/// Letters, digits, '-' and '_' only. The packing depends on zlib's version.
std::string pack(char version, std::string payload);

/// The payload of what was pasted, by pasted_text(). Refuses a text that was not taken whole, or
/// changed, or unpacks to more than max_bytes, and another version. `what` it is the text of, for
/// messages: "a replay".
carom::Result<std::string> unpack(std::string_view pasted, char version, std::string_view what);

/// The version that a text begins with; 0 if it begins with none.
char packed_version(std::string_view pasted);

/// Returns the text alone of a player's paste: of a whole link the part behind '#' and the name;
/// with no byte order mark, blanks (also those of no width), line ends of folded mail ("=" of
/// quoted-printable included), quotation marks ("> ") of a reply, or brackets, quotes and marks of
/// a sentence around it. Whatever else does not belong there stays, to be refused.
std::string pasted_text(std::string_view pasted);

/// "is damaged: …"
carom::Error damaged_text(std::string problem, std::string_view what);

}  // namespace replay
