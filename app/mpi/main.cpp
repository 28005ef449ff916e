// mpirun -n N secular-mpi blind run FOLDER: `secular` whose blind sets are worked on by many processes.
#include "app/mpi/ranks.hpp"
#include "app/program.hpp"
#include "blind/campaign_work.hpp"
#include "input/interruption.hpp"

int main(int argc, char** argv) {
  using namespace secular;
  const app::Ranks ranks(argc, argv);
  if (!ranks.is_first()) {
    Interruption::instance();  // what it has started ends with it
    ranks.serve();
    return 0;
  }
  if (ranks.others() > 0)
    blind::set_crew([&ranks](const blind::CampaignWork& work, std::size_t count, const blind::Progress& progress) {
      return ranks.hand_out(work, count, progress);
    });
  const int status = app::run_program(argc, argv);
  ranks.dismiss();
  return status;
}
