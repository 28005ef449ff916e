#include "measure/observe/modal_projection.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>

#include "input/input_error.hpp"

namespace secular {
namespace {

int derivatives_of(const Campaign& campaign, const Channel& channel) {
  switch (channel.quantity) {
    case Quantity::acceleration:
      return 2;
    case Quantity::velocity:
      return 1;
    case Quantity::force:
      throw InputError((campaign.folder / "campaign.toml").string(), "channel " + channel.name,
                       "a force cannot be a response",
                       "responses are motions: acceleration, velocity, displacement, angle");
    default:
      return 0;  // whatever it measures is the coordinate
  }
}

}  // namespace

ModalProjection modal_projection(const Campaign& campaign, const CompiledModel& model) {
  const std::string file = (campaign.folder / "campaign.toml").string();
  ModalProjection projection;
  const auto modes = static_cast<Eigen::Index>(model.modes());
  if (!campaign.modal_basis) {
    projection.channels = channels_of(campaign, ChannelRole::response);
    if (projection.channels.size() != model.modes())
      throw InputError(file, "",
                       "has " + std::to_string(projection.channels.size()) + " response channels for " +
                           std::to_string(model.modes()) + " coordinates of model " + std::string(model.name),
                       "without [modal_basis] every response channel is one coordinate, in order: " +
                           fmt::format("{}", fmt::join(model.coordinates, ", ")));
    projection.matrix = Eigen::MatrixXd::Identity(modes, modes);
  } else {
    const ModalBasis& basis = *campaign.modal_basis;
    Eigen::MatrixXd shapes(static_cast<Eigen::Index>(basis.channels.size()),
                           static_cast<Eigen::Index>(basis.modes.size()));
    for (Eigen::Index r = 0; r < shapes.rows(); ++r)
      for (Eigen::Index c = 0; c < shapes.cols(); ++c)
        shapes(r, c) = basis.mass_normalised_shapes[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)];
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(shapes);
    if (qr.rank() < shapes.cols())
      throw InputError(file, "[modal_basis]", "its mode shapes are not independent",
                       "use channels that tell the modes apart");
    const Eigen::MatrixXd inverse = shapes.completeOrthogonalDecomposition().pseudoInverse();
    projection.matrix.resize(modes, shapes.rows());
    for (std::size_t k = 0; k < model.modes(); ++k) {
      const auto found = std::find(basis.modes.begin(), basis.modes.end(), model.coordinates[k]);
      if (found == basis.modes.end())
        throw InputError(file, "[modal_basis], key modes",
                         "has no mode '" + std::string(model.coordinates[k]) + "'",
                         "model " + std::string(model.name) + " has the coordinates " +
                             fmt::format("{}", fmt::join(model.coordinates, ", ")));
      projection.matrix.row(static_cast<Eigen::Index>(k)) = inverse.row(found - basis.modes.begin());
    }
    for (const std::string& name : basis.channels)
      projection.channels.push_back(
          static_cast<std::size_t>(std::find_if(campaign.channels.begin(), campaign.channels.end(),
                                                [&](const Channel& c) { return c.name == name; }) -
                                   campaign.channels.begin()));
  }
  projection.derivatives = derivatives_of(campaign, campaign.channels[projection.channels.front()]);
  for (const std::size_t c : projection.channels)
    if (derivatives_of(campaign, campaign.channels[c]) != projection.derivatives)
      throw InputError(file, "channel " + campaign.channels[c].name,
                       "measures another derivative than the other responses",
                       "responses of one campaign are all accelerations, all velocities or all displacements");
  const Channel& first = campaign.channels[projection.channels.front()];
  const bool length = first.quantity == Quantity::acceleration || first.quantity == Quantity::velocity ||
                      first.quantity == Quantity::displacement;
  projection.unit = length ? (campaign.modal_basis ? "kg^(1/2) m" : "m") : first.unit;
  return projection;
}

std::vector<std::size_t> excitation_channels(const Campaign& campaign, const CompiledModel& model) {
  std::vector<std::size_t> channels = channels_of(campaign, ChannelRole::excitation);
  if (channels.size() < model.excitations.size())
    throw InputError((campaign.folder / "campaign.toml").string(), "",
                     "has " + std::to_string(channels.size()) + " excitation channels, the case needs " +
                         std::to_string(model.excitations.size()),
                     "give the channel that records the excitation role = \"excitation\"");
  channels.resize(model.excitations.size());
  return channels;
}

}  // namespace secular
