#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "carom/result.hpp"
#include "search/proof.hpp"

namespace search {

/// The name of a level's proof: "a.proof.json" of "a.json".
std::string proof_name(std::string_view level);

/// The other way: "a.json" of "a.proof.json"; other names stay.
std::string level_name(std::string_view proof);

/// Is true for the names of files that lie in a folder of levels without being one: proofs, and
/// "pack.json".
bool lies_beside_levels(std::string_view name);

inline constexpr std::uint64_t most_proof_games = 100'000;  ///< with each hand

/// Reads a proof from JSON (docs/formats.md). Refuses whatever is not exactly what write_proof()
/// says of such numbers, with a pointer. Nothing is played.
carom::Result<Proof> read_proof(std::string_view json);

std::string write_proof(const Proof& proof);

}  // namespace search
