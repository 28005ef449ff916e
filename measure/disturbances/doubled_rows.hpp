#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "measure/disturbances/searched_record.hpp"

namespace secular {

/// Rows, rising, that repeat the row before in all channels and do not stand for samples of their own: what follows
/// goes on as if they were not there (a buffer that was written twice). Where what follows has gone on meanwhile,
/// samples were held, and none is doubled. Clipped records are not judged. docs/inference.md (75). `samples`: of
/// each channel, as the file holds them.
std::vector<std::size_t> doubled_rows(const SearchedRecord& record,
                                      const std::vector<std::span<const double>>& samples);

/// Places without those of doubled rows and of the rows that these repeat.
std::vector<std::size_t> beside_doubled(const std::vector<std::size_t>& places,
                                        const std::vector<std::size_t>& doubled);

}  // namespace secular
