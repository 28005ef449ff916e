#pragma once

#include <filesystem>
#include <vector>

namespace secular {

/// Checks that a MAT v5 file is whole before its contents are believed: every element lies inside the one around
/// it, compressed ones inflate with the right check sum, and the numbers stored for an array are as many as its
/// dimensions say (MathWorks, "MAT-File Format", level 5). libmatio allocates what a damaged header announces; with
/// this check it never sees one. Throws InputError naming the byte.
///
/// Some writers give dimensions as unsigned numbers, which libmatio does not take: then the file's bytes are
/// returned with the type that the format asks for, else nothing.
std::vector<unsigned char> check_mat_structure(const std::filesystem::path& path);

}  // namespace secular
