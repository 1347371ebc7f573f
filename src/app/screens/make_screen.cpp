#include "app/screens/make_screen.hpp"

#include <utility>

#include "app/screens/angry_balls_screen.hpp"
#include "app/screens/billiards_screen.hpp"
#include "app/screens/help.hpp"
#include "app/screens/kept_list.hpp"
#include "app/screens/level_menu.hpp"
#include "app/screens/load_screen.hpp"
#include "app/screens/new_game.hpp"
#include "app/screens/opponent_list.hpp"
#include "app/screens/replay_list.hpp"
#include "app/screens/replay_screen.hpp"
#include "app/screens/review_screen.hpp"
#include "app/screens/settings_screen.hpp"
#include "app/screens/title_screen.hpp"

namespace app {
namespace {

using Made = std::unique_ptr<Screen>;

struct Maker {
  const Words& words;
  Session& session;

  Made operator()(const Stay&) const { return nullptr; }
  Made operator()(const Back&) const { return nullptr; }
  Made operator()(const Ask&) const { return nullptr; }
  Made operator()(const Answer&) const { return nullptr; }
  Made operator()(const Quit&) const { return nullptr; }
  Made operator()(const ShowTitle&) const { return std::make_unique<TitleScreen>(words, session); }
  Made operator()(const PlayBilliards& play) const {
    using Mode = BilliardsScreen::Mode;
    return std::make_unique<BilliardsScreen>(words, session,
                                             play.practice ? Mode::practice : Mode::game);
  }
  Made operator()(const ShowLevels&) const { return std::make_unique<LevelMenu>(words, session); }
  Made operator()(const PlayLevel& play) const {
    session.campaign.current = play.level;
    session.campaign.practice = play.practice;
    return std::make_unique<AngryBallsScreen>(words, session);
  }
  Made operator()(const ShowSavedGames&) const {
    return std::make_unique<KeptList>(words, session);
  }
  Made operator()(Load& load) const {
    return std::make_unique<LoadScreen>(words, session, std::move(load.kept));
  }
  Made operator()(Resume& resume) const {
    if (auto* table = std::get_if<BilliardsRecorder>(&resume.game))
      return std::make_unique<BilliardsScreen>(words, session, std::move(*table),
                                               std::move(resume.place));
    return std::make_unique<AngryBallsScreen>(
        words, session, std::move(std::get<LevelRecorder>(resume.game)), std::move(resume.place));
  }
  Made operator()(const ShowReplays&) const { return std::make_unique<ReplayList>(words, session); }
  Made operator()(Watch& watch) const {
    auto player = replay::Player::create(std::move(watch.replay));
    if (!player) return nullptr;  // a game that has outgrown every limit
    return std::make_unique<ReplayScreen>(words, session, std::move(player).value(), watch.turn,
                                          watch.better);
  }
  Made operator()(ShowReview& show) const {
    auto review = GameReview::begin(std::move(show.replay), error_of(session.settings.get().hand));
    if (!review) return nullptr;
    return std::make_unique<ReviewScreen>(words, session, std::move(*review));
  }
  Made operator()(const ShowSettings& show) const {
    return std::make_unique<SettingsScreen>(words, session, show.page);
  }
  Made operator()(const ShowHelp&) const { return std::make_unique<Help>(words, session); }
  Made operator()(const ShowNewGame&) const { return std::make_unique<NewGame>(words, session); }
  Made operator()(const ShowOpponents&) const {
    return std::make_unique<OpponentList>(words, session);
  }
};

}  // namespace

std::unique_ptr<Screen> make_screen(const Words& words, Session& session, Navigation request) {
  return std::visit(Maker{words, session}, request);
}

bool lies_over(const Navigation& request) {
  return std::holds_alternative<Watch>(request) || std::holds_alternative<ShowSettings>(request) ||
         std::holds_alternative<ShowHelp>(request) ||
         std::holds_alternative<ShowNewGame>(request) ||
         std::holds_alternative<ShowReview>(request) ||
         std::holds_alternative<ShowOpponents>(request);
}

}  // namespace app
