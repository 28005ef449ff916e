#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "measure/data/geometry.hpp"
#include "measure/data/line_row.hpp"
#include "measure/formats/quantity.hpp"

namespace secular {

enum class ChannelRole { excitation, response };
/// `lines`: a row of a table of lines, which stands for a dwell whose samples are not there.
enum class RecordKind { dwell, sweep, free_decay, impact, broadband, lines };

/// Whether its motion is steady, at one excitation frequency.
inline bool is_steady(RecordKind kind) {
  return kind == RecordKind::dwell || kind == RecordKind::lines;
}

/// What the motion of a response is measured against: a base that may itself move, or space.
enum class Frame { relative, absolute };

/// As in campaign.toml.
std::string to_string(ChannelRole role);
std::string to_string(RecordKind kind);

struct Channel {
  std::string name;
  ChannelRole role = ChannelRole::response;
  Quantity quantity = Quantity::acceleration;
  std::string unit;
  /// Absolute: samples in files carry the base's acceleration (of base_channel); a WatchedReader takes it out.
  Frame frame = Frame::relative;
  double delay_s = 0;  ///< by which its samples come late against the others'; a WatchedReader takes it out
};

/// Mass-normalised mode shapes: modal displacements = pinv(shapes) * channel displacements (thesis Eq. (5.32)).
struct ModalBasis {
  std::vector<std::string> channels;
  std::vector<std::string> modes;
  std::vector<std::vector<double>> mass_normalised_shapes;  ///< channels x modes
};

struct Record;

/// What campaign.toml says of one record; the samples are read on demand by read_record. A record of kind `lines`
/// is one row of its table, read with the campaign.
struct RecordEntry {
  std::string file;  ///< relative to the campaign folder; of a row "FILE:LINE"
  RecordKind kind = RecordKind::dwell;
  std::optional<double> excitation_frequency_hz;
  std::optional<double> excitation_amplitude;
  std::optional<double> ensemble_s;
  std::optional<double> started_s;
  std::string group;
  std::map<std::string, std::string> variables;  ///< channel name or "t" -> variable of the file
  std::uint32_t line = 0;                        ///< of its [[record]] in campaign.toml, 0 when made in memory
  std::shared_ptr<const LineRow> row{};          ///< kind `lines`
  std::shared_ptr<const Record> held{};          ///< samples that are in memory; none: they are in the file
};

struct Campaign {
  std::filesystem::path folder;
  std::string name;
  double sample_rate_hz = 0;  ///< 0: a campaign of tables alone, which have none
  std::vector<Channel> channels;
  std::optional<ModalBasis> modal_basis;
  std::vector<RecordEntry> records;
  std::optional<Geometry> geometry{};
};

/// What a channel's file holds before its recording begins or after it has ended.
struct Unrecorded {
  std::size_t channel = 0;
  bool at_end = false;
  std::size_t samples = 0;
  double value = 0;       ///< that is repeated there; no number: there is none
  bool replaced = false;  ///< so few that they follow from what is around them (no_numbers); else they are cut off
};

/// Samples of one record, evenly spaced: channels[c][i] at start_s + i / sample_rate_hz, in channel units.
struct Record {
  double start_s = 0;
  double sample_rate_hz = 0;
  std::vector<std::vector<double>> channels;  ///< by Campaign::channels
  double jitter_s = 0;                        ///< of its time stamps, see TimeAxis
  /// Rows that the file does not hold: their samples follow from what is around them.
  std::vector<std::size_t> lost{};
  /// By channel, samples that are no numbers in the file: they follow from what is around them. Empty: none.
  std::vector<std::vector<std::size_t>> no_numbers{};
  /// At the ends of the file. The record begins where all channels have begun, and ends with the first of them.
  std::vector<Unrecorded> unrecorded{};
  std::size_t cut_off = 0;        ///< samples at both ends, for that reason
  std::size_t cut_for_delay = 0;  ///< rows at both ends that some channel has no samples for, see Channel::delay_s
  /// Rows, rising, in which a channel holds what it did not measure and nothing around them tells what it would
  /// have.
  std::vector<std::size_t> unusable{};
  std::vector<std::size_t> moving{};  ///< channels that tell the motion, for what counts beside these; empty: all
  std::shared_ptr<const LineRow> row{};  ///< all that is known of a row of a table, which has no samples
  std::size_t samples() const { return channels.empty() ? 0 : channels.front().size(); }
};

/// The samples of a channel, rising, that the record's file does not hold: Record::lost and Record::no_numbers.
std::vector<std::size_t> filled_samples(const Record& record, std::size_t channel);

/// Channels of that role, in their order.
std::vector<std::size_t> channels_of(const Campaign& campaign, ChannelRole role);

/// The responses that a model sees: those of the modal basis, or all.
std::vector<std::size_t> seen_responses(const Campaign& campaign);

/// The channel that measures the base's acceleration: the only excitation that is an acceleration, if there is one.
std::optional<std::size_t> base_channel(const Campaign& campaign);

/// Reads campaign.toml of a folder (CONTRACT: schema 1), and the tables of lines it names: each row becomes a
/// record. Throws InputError.
Campaign read_campaign(const std::filesystem::path& folder);

/// Reads one record's samples from any file that read_data_file reads. The record's rate is campaign.toml's
/// wherever the time stamps follow it. A few lost rows, and a few samples in a row that are no numbers (empty, NaN,
/// infinity), follow from what is around them; ends where nothing was recorded are cut off (cut_unrecorded). Throws
/// InputError for a missing column, text where a number should
/// be, more samples that are no numbers, time that does not increase evenly (names the place), a sample rate that
/// contradicts campaign.toml by more than 0.1 %. Of a row of a table there are no samples, but Record::row. Samples
/// that are held in memory (RecordEntry::held) are given as they are.
Record read_record(const Campaign& campaign, const RecordEntry& entry);

}  // namespace secular
