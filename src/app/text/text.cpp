#include "app/text/text.hpp"

#include <array>
#include <cmath>
#include <cstdlib>

namespace app {
namespace {

/// {0} stands for a value, [C] for what a hand does (signs); what follows [|] is for those with
/// keys.
struct Entry {
  Text text;
  std::array<std::string_view, 2> in;  ///< by Language
};

constexpr std::array<Entry, static_cast<std::size_t>(Text::count)> entries{{
    {Text::product, {"Angry Balls", "Angry Balls"}},
    {Text::tagline, {"Two games, one furious ball", "Deux jeux, une boule furieuse"}},
    {Text::title_screen, {"title screen", "écran titre"}},
    {Text::billiards, {"Billiards", "Billard"}},
    {Text::angry_balls, {"Angry Balls", "Angry Balls"}},
    {Text::quit, {"Quit", "Quitter"}},
    {Text::player, {"Player {0}", "Joueur {0}"}},
    {Text::to_play, {"To play", "À jouer"}},
    {Text::waiting, {"Waiting", "En attente"}},
    {Text::balls_left, {"Balls left", "Boules"}},
    {Text::this_turn, {"This turn", "Ce tour"}},
    {Text::restart, {"Restart", "Rejouer"}},
    {Text::close, {"Close", "Fermer"}},
    {Text::retry, {"Try again", "Réessayer"}},
    {Text::hint_take_cue_ball,
     {"[C] the white cue ball to aim.", "[C] [S]la boule blanche pour viser."}},
    {Text::hint_not_cue_ball,
     {"That is not the cue ball: [c] the white one first.",
      "Pas celle-là : [c] d’abord [S]la boule blanche."}},
    {Text::hint_shoot,
     {"[C] where to send it. [B]: take it back.", "[C] où l’envoyer. [B] : annuler."}},
    {Text::hint_too_weak,
     {"Too weak to move the ball: [c] further away.",
      "Trop faible pour la boule : [c] plus loin."}},
    {Text::hint_watch,
     {"The balls are rolling…[|] Hold {0}: faster. {1}: pause.",
      "Les boules roulent…[|] {0} maintenue : plus vite. {1} : pause."}},
    {Text::hint_place, {"[C] where to put the cue ball down.", "[C] où poser la boule blanche."}},
    {Text::hint_obstructed, {"It cannot lie here: {0}.", "Elle ne peut pas être ici : {0}."}},
    {Text::on_ball, {"another ball is in the way", "une autre boule gêne"}},
    {Text::on_hole, {"over a pocket", "au-dessus d’un trou"}},
    {Text::on_cushion, {"off the table", "hors de la table"}},
    {Text::speed, {"{0} px/s", "{0} px/s"}},
    {Text::speed_capped, {"{0} px/s · max", "{0} px/s · max"}},
    {Text::points, {"+{0}", "+{0}"}},
    {Text::turn_of, {"{0} to play", "{0}, à vous de jouer"}},
    {Text::turn_scored, {"{0} made {1} points", "{0} a marqué {1} points"}},
    {Text::turn_nothing, {"{0} made no points", "{0} n’a rien marqué"}},
    {Text::cue_ball_in_hand,
     {"Cue ball pocketed: place it anywhere", "Boule blanche tombée : replacez-la"}},
    {Text::wins, {"{0} wins!", "{0} gagne !"}},
    {Text::draw, {"It’s a draw", "Match nul"}},
    {Text::play_again, {"Play again", "Rejouer"}},
    {Text::back_to_title, {"Back to title", "Retour au titre"}},
    {Text::ask_restart, {"Start again?", "Recommencer ?"}},
    {Text::ask_leave, {"Leave the table?", "Quitter la table ?"}},
    {Text::game_is_lost, {"This game will be lost.", "Cette partie sera perdue."}},
    {Text::new_game, {"New game", "Nouvelle partie"}},
    {Text::leave, {"Leave", "Quitter"}},
    {Text::keep_playing, {"Keep playing", "Continuer"}},
    {Text::aiming, {"{0} aims", "{0} vise"}},
    {Text::watching, {"{0} watches the shot", "{0} regarde son tir"}},
    {Text::placing, {"{0} places the cue ball", "{0} place la boule blanche"}},
    {Text::state,
     {"{0} · {1} · {5}: {2} · {6}: {3} · balls left: {4}",
      "{0} · {1} · {5} : {2} · {6} : {3} · boules restantes : {4}"}},
    {Text::choose_level, {"Choose a level", "Choisissez un niveau"}},
    {Text::level_menu, {"level menu", "choix du niveau"}},
    {Text::best, {"Best: {0}", "Record : {0}"}},
    {Text::not_won_yet, {"Not won yet", "À gagner"}},
    {Text::page, {"Page {0} of {1}", "Page {0} sur {1}"}},
    {Text::previous_page, {"‹ Previous", "‹ Avant"}},
    {Text::next_page, {"Next ›", "Après ›"}},
    {Text::title_button, {"Title", "Titre"}},
    {Text::hint_choose_level,
     {"Break every horned ball, or drive it out.",
      "Brisez ou chassez toutes les boules à cornes."}},
    {Text::hint_broken_level, {"Cannot be played: {0}", "Injouable : {0}"}},
    {Text::scores_set_aside,
     {"The scores could not be read; they are kept as scores.json.broken.",
      "Records illisibles, mis de côté dans scores.json.broken."}},
    {Text::scores_not_kept,
     {"Best scores cannot be saved.", "Les records ne peuvent pas être gardés."}},
    {Text::menu, {"Menu", "Menu"}},
    {Text::score, {"Score", "Score"}},
    {Text::throws, {"Throws", "Lancers"}},
    {Text::enemies, {"Enemies", "Ennemis"}},
    {Text::goal, {"Enemies: {0} · throws: {1}", "Ennemis : {0} · lancers : {1}"}},
    {Text::level_and_name, {"Level {0}: {1}", "Niveau {0} : {1}"}},
    {Text::hint_take_projectile, {"[C] the angry ball to take it.", "[C] [S]la boule en colère."}},
    {Text::hint_not_projectile,
     {"Not there: [c] the angry ball on its post.", "Pas là : [c] [S]la boule en colère."}},
    {Text::hint_throw,
     {"[C] where to throw it. [B]: take it back.", "[C] où la lancer. [B] : annuler."}},
    {Text::hint_flying,
     {"There it goes…[|] Hold {0}: faster. {1}: pause.",
      "C’est parti…[|] {0} maintenue : plus vite. {1} : pause."}},
    {Text::hint_next,
     {"All is calm. [C] for the next throw.[|] Or press {0}.",
      "Tout est calme. [C] pour relancer.[|] Ou touche {0}."}},
    {Text::hint_finish,
     {"That was the last throw. [C] to end.[|] Or press {0}.",
      "C’était le dernier lancer. [C] pour finir.[|] Ou touche {0}."}},
    {Text::next_throw, {"Next throw[|] ({0})", "Lancer suivant[|] ({0})"}},
    {Text::finish, {"End of the level[|] ({0})", "Fin du niveau[|] ({0})"}},
    {Text::won, {"Level won!", "Niveau gagné !"}},
    {Text::lost, {"Level lost", "Niveau perdu"}},
    {Text::new_best, {"A new best score!", "Nouveau record !"}},
    {Text::throws_used, {"Throws used: {0} of {1}", "Lancers : {0} sur {1}"}},
    {Text::enemies_remain, {"Enemies left: {0}", "Ennemis restants : {0}"}},
    {Text::next_level, {"Next level", "Suivant"}},
    {Text::ask_leave_level, {"Leave the level?", "Quitter le niveau ?"}},
    {Text::level_is_lost, {"This try will be lost.", "Cet essai sera perdu."}},
    {Text::ready_to_throw, {"[c] the angry ball to throw", "[c] [S]la boule pour lancer"}},
    {Text::watching_throw, {"watching the throw", "le lancer est en cours"}},
    {Text::next_offered, {"[c] for the next throw", "[c] pour le lancer suivant"}},
    {Text::finish_offered, {"[c] to end the level", "[c] pour finir le niveau"}},
    {Text::level_state,
     {"{0} · {1} · {2} · score: {3} · throws left: {4} · enemies left: {5}",
      "{0} · {1} · {2} · score : {3} · lancers restants : {4} · ennemis restants : {5}"}},
    {Text::menu_state, {"{0} · {1} · levels: {2}", "{0} · {1} · niveaux : {2}"}},
    {Text::continue_billiards,
     {"Continue: billiards, player {0}", "Reprendre : billard, joueur {0}"}},
    {Text::continue_table, {"Continue: billiards", "Reprendre : billard"}},
    {Text::continue_level, {"Continue: level {0}", "Reprendre : niveau {0}"}},
    {Text::continue_named_level, {"Continue: {0}", "Reprendre : {0}"}},
    {Text::practice, {"Practice", "S’exercer"}},
    {Text::replays, {"Replays", "Revoir"}},
    {Text::ask_new_game, {"Give up the game kept?", "Abandonner la partie ?"}},
    {Text::continue_game, {"Continue it", "La reprendre"}},
    {Text::kept_billiards, {"Player 1: {0} · Player 2: {1}", "Joueur 1 : {0} · Joueur 2 : {1}"}},
    {Text::other_level, {"Other level", "Autre niveau"}},
    {Text::kept_refused_billiards, {"Billiards: not continued", "Billard : pas de reprise"}},
    {Text::kept_refused_level, {"Level: not continued", "Niveau : pas de reprise"}},
    {Text::kept_set_aside, {"It is kept under another name:", "Elle est mise de côté sous le nom"}},
    {Text::kept_file, {"{0}.broken", "{0}.broken"}},
    {Text::kept_blocked, {"New games cannot be kept.", "La suite ne sera pas gardée."}},
    {Text::fault_damaged, {"The game kept is damaged.", "La partie gardée est abîmée."}},
    {Text::fault_other_version,
     {"It was made by another version.", "Elle vient d’une autre version."}},
    {Text::fault_diverged,
     {"It does not go as it was recorded.", "Elle ne se rejoue pas telle quelle."}},
    {Text::fault_finished, {"That game is already over.", "Cette partie est déjà finie."}},
    {Text::ok, {"OK", "OK"}},
    {Text::not_kept, {"This game cannot be kept", "Cette partie ne peut être gardée"}},
    {Text::loading, {"Loading your game…", "Chargement de la partie…"}},
    {Text::turns_loaded, {"Turn {0} of {1}", "Tour {0} sur {1}"}},
    {Text::cancel, {"Cancel", "Annuler"}},
    {Text::watch_replay, {"Watch replay", "Revoir"}},
    {Text::replay_title, {"replay", "partie revue"}},
    {Text::replay_state,
     {"{0} · {1} · {2} · {3} · {4} · {5} · {6}", "{0} · {1} · {2} · {3} · {4} · {5} · {6}"}},
    {Text::replay_playing, {"playing ×{0}", "lecture ×{0}"}},
    {Text::replay_paused, {"paused", "en pause"}},
    {Text::play, {"Play", "Lire"}},
    {Text::pause, {"Pause", "Pause"}},
    {Text::one_step, {"Step", "Pas"}},
    {Text::previous_turn, {"‹ Turn", "‹ Tour"}},
    {Text::following_turn, {"Turn ›", "Tour ›"}},
    {Text::slower, {"−", "−"}},
    {Text::faster, {"+", "+"}},
    {Text::times, {"×{0}", "×{0}"}},
    {Text::save_replay, {"Save", "Garder"}},
    {Text::copy, {"Copy", "Copier"}},
    {Text::turn_of_turns, {"Turn {0} of {1}", "Tour {0} sur {1}"}},
    {Text::turn_of_player, {"Turn {0} of {1} · player {2}", "Tour {0} sur {1} · joueur {2}"}},
    {Text::verifying, {"Verifying…", "Vérification…"}},
    {Text::verified, {"Verified", "Vérifiée"}},
    {Text::diverged, {"Diverged in turn {0}", "Diverge au tour {0}"}},
    {Text::hint_replay,
     {"Space: play, pause · dot: step · + −: speed · arrows: turns",
      "Espace : lire · point : pas · + − : vitesse · flèches : tours"}},
    {Text::replay_saved, {"Saved as {0}.", "Gardée sous le nom {0}."}},
    {Text::replay_not_saved, {"It cannot be saved.", "Elle ne peut pas être gardée."}},
    {Text::replay_copied,
     {"Copied as text: paste it anywhere.", "Copiée : collez le texte où vous voulez."}},
    {Text::replay_not_copied, {"It cannot be copied.", "Elle ne peut pas être copiée."}},
    {Text::score_pair, {"{0} : {1}", "{0} : {1}"}},
    {Text::saved_replays, {"Saved replays", "Parties gardées"}},
    {Text::paste, {"Paste", "Coller"}},
    {Text::no_replays,
     {"No replay is saved yet. Watch one after a game, or paste its text here.",
      "Rien n’est gardé. Revoyez une partie à sa fin, ou collez-en le texte ici."}},
    {Text::hint_replays,
     {"Choose a replay, or paste one as text.[|] Ctrl+V pastes.",
      "Choisissez, ou collez un texte.[|] Ctrl+V : coller."}},
    {Text::replay_line, {"{0} · turns: {1} · {2}", "{0} · tours : {1} · {2}"}},
    {Text::replays_state, {"{0} · {1} · replays: {2}", "{0} · {1} · parties : {2}"}},
    {Text::bad_replay, {"Cannot be shown: it is damaged.", "Illisible : le fichier est abîmé."}},
    {Text::old_replay,
     {"Cannot be shown: it was made by another version.",
      "Illisible : elle vient d’une autre version."}},
    {Text::paste_failed, {"Nothing to show", "Rien à montrer"}},
    {Text::paste_damaged,
     {"What was pasted is not a whole replay.", "Le texte collé n’est pas une partie."}},
    {Text::paste_other_version,
     {"It was made by another version.", "Elle vient d’une autre version."}},
    {Text::take_back, {"Take back", "Annuler"}},
    {Text::repeat, {"Repeat", "Répéter"}},
    {Text::slower_throw, {"−1 px/s", "−1 px/s"}},
    {Text::faster_throw, {"+1 px/s", "+1 px/s"}},
    {Text::turn_left, {"+0.1°", "+0,1°"}},
    {Text::turn_right, {"−0.1°", "−0,1°"}},
    {Text::hint_repeat,
     {"{0} repeats {1}. Backspace takes back.", "{0} répète {1}. Retour arrière : annuler."}},
    {Text::practised, {"{0} px/s, {1}°", "{0} px/s, {1}°"}},
    {Text::practice_state, {"practice: {0}", "exercice : {0}"}},
    {Text::practice_on, {"Practice: on", "Exercice : oui"}},
    {Text::practice_off, {"Practice: off", "Exercice : non"}},
    {Text::hint_practice_levels,
     {"Throws can be taken back; nothing enters the best scores.",
      "Lancers annulables ; aucun record n’est noté."}},
    {Text::practice_only, {"Practice: no best score", "Exercice : pas de record"}},
    {Text::shoot, {"Shoot", "Tirer"}},
    {Text::hint_touch_shoot,
     {"Turn; then Shoot, or tap the ball.", "Visez, puis Tirer, ou touchez la boule."}},
    {Text::nudge_pull,
     {"Your turn: pull this ball back, then let go.",
      "À vous : tirez cette boule en arrière, puis lâchez."}},
    {Text::nudge_click,
     {"Your turn: [c] this ball, then where to send it.",
      "À vous : [c] [S]la boule, puis où l’envoyer."}},
    {Text::nudge_turn,
     {"Your turn: point where to shoot, then click.", "À vous : visez, puis cliquez pour tirer."}},
    {Text::nudge_place,
     {"Put this ball down: [c] its place.[|] Or arrows and Enter.",
      "Posez la boule : [c] [S]sa place.[|] Ou flèches et Entrée."}},
    {Text::lesson_1, {"Press on the ball", "Prenez la boule"}},
    {Text::lesson_2, {"Pull it back", "Tirez en arrière"}},
    {Text::lesson_3, {"Let go!", "Lâchez !"}},
    {Text::touch_turn, {"Touch where to aim, then Shoot.", "Touchez vers où viser, puis Tirer."}},
    {Text::touch_replay,
     {"Touch the bar to go to a turn.", "Touchez la barre pour aller à un tour."}},
    {Text::touch_watch,
     {"Rolling… Hold a finger down: faster.", "Ça roule… Doigt maintenu : plus vite."}},
    {Text::touch_flying,
     {"There it goes… Hold a finger down: faster.", "C’est parti… Doigt maintenu : plus vite."}},
    {Text::touch_repeat, {"Repeat: {1} once more.", "Répéter : encore {1}."}},
    {Text::pad_aim,
     {"Left stick: aim. Triggers: power. A: shoot.",
      "Stick gauche : viser. Gâchettes : force. A : tirer."}},
    {Text::pad_shoot,
     {"A: shoot. B: cancel. LB, RB: aim finer.", "A : tirer. B : annuler. LB, RB : plus fin."}},
    {Text::pad_place,
     {"Left stick: carry the ball. A: put it down.",
      "Stick gauche : porter la boule. A : la poser."}},
    {Text::pad_settings,
     {"D-pad: choose a line, change it.", "Croix directionnelle : choisir, changer."}},
    {Text::pad_replay,
     {"Start: play, pause · D-pad: turns, speed · X: buttons",
      "Start : lire · Croix directionnelle : tours, vitesse · X : boutons"}},
    {Text::pad_ready, {"A to throw", "A pour lancer"}},
    {Text::pad_lesson_1, {"Left stick: aim", "Stick gauche : viser"}},
    {Text::pad_lesson_2, {"Triggers: power", "Gâchettes : force"}},
    {Text::pad_lesson_3, {"A: shoot!", "A : tirez !"}},
    {Text::tip_restart, {"Starts anew from the first shot", "Reprend depuis le premier tir"}},
    {Text::tip_close, {"Leaves the game[|] (Esc)", "Quitte la partie[|] (Échap)"}},
    {Text::tip_take_back, {"Back to before the last throw", "Revient avant le dernier tir"}},
    {Text::tip_repeat, {"Throws just so once more", "Refait le même tir"}},
    {Text::tip_slower_throw,
     {"The next throw is a little weaker", "Le prochain tir, un peu plus faible"}},
    {Text::tip_faster_throw,
     {"The next throw is a little stronger", "Le prochain tir, un peu plus fort"}},
    {Text::tip_turn_left,
     {"The next throw turns a little left", "Le prochain tir, un peu à gauche"}},
    {Text::tip_turn_right,
     {"The next throw turns a little right", "Le prochain tir, un peu à droite"}},
    {Text::tip_continue, {"Goes on where you left off", "Reprend où vous en étiez"}},
    {Text::tip_billiards, {"A game for two, in turns", "Une partie à deux, chacun son tour"}},
    {Text::tip_practice_table,
     {"Alone; shots can be taken back", "Seul ; on peut annuler ses tirs"}},
    {Text::tip_angry_balls, {"Three throws to clear a level", "Trois lancers par niveau"}},
    {Text::tip_replays, {"Games you saved", "Les parties gardées"}},
    {Text::tip_settings, {"Language, sound, players[|] (F10)", "Langue, son, joueurs[|] (F10)"}},
    {Text::tip_quit, {"Closes the program[|] (Esc)", "Ferme le programme[|] (Échap)"}},
    {Text::tip_practice_levels,
     {"Take throws back; no best scores", "Lancers annulables, sans record"}},
    {Text::tip_title, {"Back to the title[|] (Esc)", "Retour au titre[|] (Échap)"}},
    {Text::tip_page, {"Turns the page", "Tourne la page"}},
    {Text::tip_keys, {"Puts commands on other letters", "Change la lettre des commandes"}},
    {Text::tip_close_help, {"Back to where you were[|] (Esc)", "Retour[|] (Échap)"}},
    {Text::tip_help,
     {"Every key and gesture[|] (F1)", "Toutes les touches, tous les gestes[|] (F1)"}},
    {Text::tip_paste,
     {"Shows the replay you copied[|] (Ctrl+V)", "Montre la partie copiée[|] (Ctrl+V)"}},
    {Text::tip_previous_turn, {"To the turn before[|] (←)", "Au tour d’avant[|] (←)"}},
    {Text::tip_following_turn, {"To the next turn[|] (→)", "Au tour suivant[|] (→)"}},
    {Text::tip_play, {"Plays or stops[|] (Space)", "Lit ou arrête[|] (Espace)"}},
    {Text::tip_step, {"One step of 1/100 s[|] (.)", "Un pas de 1/100 s[|] (.)"}},
    {Text::tip_slower, {"Slower[|] (−)", "Plus lent[|] (−)"}},
    {Text::tip_faster, {"Faster[|] (+)", "Plus vite[|] (+)"}},
    {Text::tip_save, {"Keeps it among your replays", "La garde dans Revoir"}},
    {Text::tip_copy, {"Copies it as a text[|] (Ctrl+C)", "La copie en texte[|] (Ctrl+C)"}},
    {Text::tip_close_replay, {"Back to where you were[|] (Esc)", "Retour[|] (Échap)"}},
    {Text::tip_open, {"A replay or a level", "Une partie ou un niveau"}},
    {Text::tip_give_up, {"Gives this game up", "Abandonne cette partie"}},
    {Text::tip_watch, {"Shows this game again", "Montre cette partie"}},
    {Text::tip_menu, {"Back to the levels[|] (Esc)", "Retour aux niveaux[|] (Échap)"}},
    {Text::tip_next_level, {"Goes on to the next level", "Passe au niveau suivant"}},
    {Text::tip_next, {"Puts the ball back on its post", "Remet la boule sur son support"}},
    {Text::tip_finish, {"Shows how it ended", "Montre le résultat"}},
    {Text::tip_shoot, {"Shoots as shown", "Tire comme indiqué"}},
    {Text::tip_level,
     {"Play it. Enemies: {0}, throws: {1}", "Jouer. Ennemis : {0}, lancers : {1}"}},
    {Text::tip_key, {"Then press its new letter", "Puis tapez sa lettre"}},
    {Text::tip_defaults, {"Every command on its first letter", "Remet chaque lettre"}},
    {Text::help, {"Help", "Aide"}},
    {Text::change_keys, {"Keys…", "Touches…"}},
    {Text::help_back, {"Back", "Retour"}},
    {Text::help_aim_title, {"Aim", "Viser"}},
    {Text::help_aim,
     {"← →\tTurn by 1°\n↑ ↓\tSpeed, by 10 px/s\nShift, Ctrl\t0.1° and 1 px/s\n0…9\tType angle and "
      "speed\nEnter\tAim, then shoot\nSpace\tShoot, or power\nEsc\tTake it back",
      "← →\tTourner de 1°\n↑ ↓\tVitesse, de 10 px/s\nMaj, Ctrl\t0,1° et 1 px/s\n0…9\tSaisir angle "
      "et vitesse\nEntrée\tViser, puis tirer\nEspace\tTirer, ou la force\nÉchap\tAnnuler"}},
    {Text::help_game_title, {"Game", "Partie"}},
    {Text::help_game,
     {"{0}\tStart again, repeat\n{1}\tNext throw\n{2}\tPause\n{3}\tFaster, while held\n{4}\tSound "
      "on, off\nBackspace\tTake back (practice)\nArrows\tBall in "
      "hand\nEnter\tPut it down\nF10\tSettings\nF11\tFull screen\nF1, ?\tThis help",
      "{0}\tRecommencer, répéter\n{1}\tLancer suivant\n{2}\tPause\n{3}\tPlus vite, si "
      "tenue\n{4}\tSon, silence\nRet. arr.\tAnnuler "
      "(exercice)\nFlèches\tBoule en main\nEntrée\tLa poser\nF10\tRéglages\nF11\tPlein écran\nF1, "
      "?\tCette aide"}},
    {Text::help_replay_title, {"Replay", "Revoir"}},
    {Text::help_replay,
     {"Space\tPlay, stop\n.\tOne step\n+ −\tSpeed\n← →\tTurns\nCtrl+C\tCopy as text",
      "Espace\tLire, arrêter\n.\tUn pas\n+ −\tVitesse\n← →\tTours\nCtrl+C\tCopier en texte"}},
    {Text::help_menu_title, {"Menus", "Menus"}},
    {Text::help_menu,
     {"Tab, arrows\tMove\nEnter\tChoose\nEsc\tBack\nCtrl+V\tPaste a replay",
      "Tab, flèches\tSe déplacer\nEntrée\tChoisir\nÉchap\tRetour\nCtrl+V\tColler une partie"}},
    {Text::help_mouse_title, {"Mouse", "Souris"}},
    {Text::help_mouse,
     {"Pull, let go\tAim and shoot\nTwo clicks\tBall, then target\nWheel\tSpeed\nRight click\tTake "
      "it back",
      "Tirer, lâcher\tViser et tirer\nDeux clics\tBoule, puis cible\nMolette\tVitesse\nClic "
      "droit\tAnnuler"}},
    {Text::help_touch_title, {"Touch", "Écran tactile"}},
    {Text::help_touch,
     {"Pull, let go\tAim and shoot\nTwo taps\tBall, then target\nTwo fingers\tTake it "
      "back\nHold\tFaster, "
      "while they roll",
      "Tirer, lâcher\tViser et tirer\nDeux appuis\tBoule, puis cible\nDeux "
      "doigts\tAnnuler\nMaintenir\tPlus "
      "vite, quand ça roule"}},
    {Text::help_pad_title, {"Gamepad", "Manette"}},
    {Text::help_pad,
     {"D-pad\tMove, aim\nA, B\tChoose or shoot, back\nLeft stick\tTurn, carry the ball\nRight "
      "stick\tPower; triggers too\nRT, held\tFaster\nLB, RB\tTurn by 0.1°\nX, View\tTo the "
      "buttons\nStart\tPause\nY\tThis help",
      "Croix direct.\tAller, viser\nA, B\tChoisir ou tirer, retour\nStick gauche\tTourner, porter "
      "la "
      "boule\nStick droit\tForce ; gâchettes aussi\nRT tenue\tPlus vite\nLB, RB\tTourner de "
      "0,1°\nX, View\tVers les "
      "boutons\nStart\tPause\nY\tCette aide"}},
    {Text::keys_title, {"Keys", "Touches"}},
    {Text::key_again, {"Start again, repeat", "Recommencer, répéter"}},
    {Text::key_next, {"Next throw", "Lancer suivant"}},
    {Text::key_pause, {"Pause", "Pause"}},
    {Text::key_fast, {"Faster, while held", "Plus vite, si tenue"}},
    {Text::key_mute, {"Sound on, off", "Son, silence"}},
    {Text::key_line, {"{0}: {1}", "{0} : {1}"}},
    {Text::key_wanted, {"{0}: press a letter", "{0} : une lettre"}},
    {Text::key_taken, {"That letter is taken.", "Cette lettre est prise."}},
    {Text::key_no_letter, {"Only letters can be chosen.", "Seulement des lettres."}},
    {Text::key_defaults, {"Defaults", "Par défaut"}},
    {Text::hint_keys_panel,
     {"Choose a line, then press a letter.", "Choisissez, puis tapez une lettre."}},
    {Text::aimed, {"{0}° · {1}", "{0}° · {1}"}},
    {Text::entered_angle, {"{0} °", "{0} °"}},
    {Text::entered_speed, {"{0} px/s", "{0} px/s"}},
    {Text::hint_pull,
     {"Pull the ball back and let go.[|] Keys: arrows, Enter.",
      "Tirez la boule en arrière, lâchez.[|] Clavier : flèches, Entrée."}},
    {Text::hint_let_go,
     {"Let go to shoot. Back to the ball: cancel.[|] Or Esc.",
      "Lâchez pour tirer. Retour à la boule : annuler.[|] Ou Échap."}},
    {Text::hint_turn,
     {"Point to turn; wheel, Space or bar: power. Click to shoot.",
      "Visez ; force : molette, Espace, barre. Cliquez : tirer."}},
    {Text::hint_keys,
     {"Arrows aim, Shift: finer, digits: type it. Enter shoots.",
      "Flèches : viser, Maj : plus fin, chiffres. Entrée : tirer."}},
    {Text::hint_entry,
     {"Type angle and speed. Tab: the other. Enter: take them.",
      "Saisissez angle et vitesse. Tab : l’autre. Entrée : valider."}},
    {Text::points_made, {"Points", "Points"}},
    {Text::balls, {"Balls", "Boules"}},
    {Text::best_turn, {"Best turn", "Meilleur tour"}},
    {Text::shots, {"Shots", "Tirs"}},
    {Text::fouls, {"Fouls", "Fautes"}},
    {Text::settings, {"Settings", "Réglages"}},
    {Text::settings_state, {"{0} · {1} · {2}", "{0} · {1} · {2}"}},
    {Text::settings_broken, {"Settings: starting afresh", "Réglages : valeurs de départ"}},
    {Text::settings_unreadable,
     {"The settings could not be read.", "Les réglages sont illisibles."}},
    {Text::settings_set_aside,
     {"They are kept under another name:", "Ils sont mis de côté sous le nom"}},
    {Text::settings_blocked, {"Changes cannot be saved.", "Rien ne peut être gardé."}},
    {Text::settings_not_kept,
     {"Settings cannot be saved: they last until the end.",
      "Les réglages ne peuvent pas être gardés."}},
    {Text::hint_settings,
     {"[C] a line to change it.[|] Or use Tab and the arrow keys.",
      "[C] [S]une ligne pour la changer.[|] Ou Tab et flèches."}},
    {Text::tab_general, {"General", "Général"}},
    {Text::tab_picture, {"Picture", "Image"}},
    {Text::tab_aiming, {"Aiming", "Visée"}},
    {Text::tab_players, {"Players", "Joueurs"}},
    {Text::set_language, {"Language", "Langue"}},
    {Text::set_volume, {"Volume", "Volume"}},
    {Text::set_mute, {"Mute", "Muet"}},
    {Text::set_hints, {"Hints", "Conseils"}},
    {Text::set_colours, {"Colours", "Couleurs"}},
    {Text::set_motion, {"Less motion", "Animations réduites"}},
    {Text::set_shake, {"Screen shake", "Secousses"}},
    {Text::set_way, {"Way of aiming", "Façon de viser"}},
    {Text::set_preview, {"Preview", "Aperçu du tir"}},
    {Text::set_name, {"Name of player {0}", "Nom du joueur {0}"}},
    {Text::set_breaks, {"Who breaks", "Qui commence"}},
    {Text::set_keep_turn, {"Score and play on", "Qui marque rejoue"}},
    {Text::about_language,
     {"The language of everything, at once.", "La langue de tout le jeu, aussitôt."}},
    {Text::about_volume, {"How loud balls and cushions are.", "La force des sons."}},
    {Text::about_mute, {"No sound at all.", "Aucun son."}},
    {Text::about_hints,
     {"Tell what to do when nothing happens for a while.",
      "Dit quoi faire quand rien ne se passe."}},
    {Text::about_colours,
     {"Palettes for eyes that see some colours alike.",
      "Palettes pour qui confond certaines couleurs."}},
    {Text::about_motion,
     {"Fewer moving effects, for those whom they bother.",
      "Moins d’effets animés, s’ils vous gênent."}},
    {Text::about_shake,
     {"A hard shock may shake the picture.", "Un choc violent peut secouer l’image."}},
    {Text::about_way,
     {"What mouse or finger does to aim. The keys always can.",
      "Comment viser à la souris ou au doigt. Les touches y servent toujours."}},
    {Text::about_preview,
     {"How much of the shot is shown ahead. All of it: in practice only.",
      "La part du tir montrée d’avance. Tout : à l’exercice seulement."}},
    {Text::about_name,
     {"Type a name; empty, it is “Player {0}”.", "Tapez un nom ; sans nom : « Joueur {0} »."}},
    {Text::about_breaks,
     {"Who has the first turn, from the next game of billiards on.",
      "Qui joue le premier tour, dès la prochaine partie de billard."}},
    {Text::about_keep_turn,
     {"House rule: whoever pockets a ball plays again. From the next game on.",
      "Règle maison : qui marque rejoue. Dès la prochaine partie."}},
    {Text::as_system, {"System default", "Comme le système"}},
    {Text::english, {"English", "English"}},
    {Text::french, {"Français", "Français"}},
    {Text::per_cent, {"{0}%", "{0}\u202f%"}},
    {Text::yes, {"Yes", "Oui"}},
    {Text::no, {"No", "Non"}},
    {Text::colours_standard, {"Standard", "Standard"}},
    {Text::colours_red_green, {"For red and green", "Pour rouge et vert"}},
    {Text::colours_blue_yellow, {"For blue and yellow", "Pour bleu et jaune"}},
    {Text::colours_high_contrast, {"High contrast", "Contraste élevé"}},
    {Text::way_clicks, {"Two [k]", "Deux [k]"}},
    {Text::way_pull, {"Drag back, let go", "Tirer et lâcher"}},
    {Text::way_turn, {"Turn, then power", "Tourner, puis doser"}},
    {Text::preview_off, {"Off", "Aucun"}},
    {Text::preview_contact, {"To the first contact", "Premier contact"}},
    {Text::preview_short, {"A little further", "Un peu plus loin"}},
    {Text::preview_full, {"All of it", "Tout"}},
    {Text::breaks_alternate, {"In turn", "À tour de rôle"}},
    {Text::breaks_loser, {"The loser", "Le perdant"}},
    {Text::sound_on, {"Sound on", "Son activé"}},
    {Text::sound_off, {"Sound off[|] ({0}: on)", "Son coupé[|] ({0} : rétablir)"}},
    {Text::paused, {"Paused", "Pause"}},
    {Text::hint_paused, {"[C] to go on.[|] Or press Space.", "[C] pour continuer.[|] Ou Espace."}},
    {Text::paused_state, {"paused: {0}", "en pause : {0}"}},
    {Text::open_file, {"Open a file", "Ouvrir…"}},
    {Text::unnamed_level, {"Unnamed level", "Niveau sans nom"}},
    {Text::link_refused, {"This link cannot be opened", "Ce lien est illisible"}},
    {Text::link_damaged,
     {"It is damaged, or not whole: copy it again.", "Il est abîmé ou incomplet : recopiez-le."}},
    {Text::file_refused, {"This file cannot be opened", "Ce fichier est illisible"}},
    {Text::level_not_kept,
     {"The level could not be kept: it is gone after this game.",
      "Le niveau n’a pas pu être gardé."}},
}};

/// What is said instead to who plays by another hand than the mouse.
struct ByHand {
  InputDevice hand;
  Text text;
  Text instead;
};
constexpr std::array by_hand{
    ByHand{InputDevice::finger, Text::hint_turn, Text::touch_turn},
    ByHand{InputDevice::finger, Text::nudge_turn, Text::touch_turn},
    ByHand{InputDevice::finger, Text::hint_replay, Text::touch_replay},
    ByHand{InputDevice::finger, Text::hint_watch, Text::touch_watch},
    ByHand{InputDevice::finger, Text::hint_flying, Text::touch_flying},
    ByHand{InputDevice::finger, Text::hint_repeat, Text::touch_repeat},
    ByHand{InputDevice::pad, Text::hint_repeat, Text::touch_repeat},
    ByHand{InputDevice::pad, Text::hint_take_cue_ball, Text::pad_aim},
    ByHand{InputDevice::pad, Text::hint_not_cue_ball, Text::pad_aim},
    ByHand{InputDevice::pad, Text::hint_take_projectile, Text::pad_aim},
    ByHand{InputDevice::pad, Text::hint_not_projectile, Text::pad_aim},
    ByHand{InputDevice::pad, Text::hint_pull, Text::pad_aim},
    ByHand{InputDevice::pad, Text::hint_turn, Text::pad_aim},
    ByHand{InputDevice::pad, Text::nudge_pull, Text::pad_aim},
    ByHand{InputDevice::pad, Text::nudge_click, Text::pad_aim},
    ByHand{InputDevice::pad, Text::nudge_turn, Text::pad_aim},
    ByHand{InputDevice::pad, Text::hint_shoot, Text::pad_shoot},
    ByHand{InputDevice::pad, Text::hint_throw, Text::pad_shoot},
    ByHand{InputDevice::pad, Text::hint_too_weak, Text::pad_aim},
    ByHand{InputDevice::pad, Text::hint_keys, Text::pad_shoot},
    ByHand{InputDevice::pad, Text::hint_place, Text::pad_place},
    ByHand{InputDevice::pad, Text::nudge_place, Text::pad_place},
    ByHand{InputDevice::pad, Text::hint_settings, Text::pad_settings},
    ByHand{InputDevice::pad, Text::hint_replay, Text::pad_replay},
    ByHand{InputDevice::pad, Text::ready_to_throw, Text::pad_ready},
    ByHand{InputDevice::pad, Text::lesson_1, Text::pad_lesson_1},
    ByHand{InputDevice::pad, Text::lesson_2, Text::pad_lesson_2},
    ByHand{InputDevice::pad, Text::lesson_3, Text::pad_lesson_3},
};

/// What a sign in brackets stands for, by InputDevice and Language.
struct Sign {
  char sign;
  std::array<std::array<std::string_view, 2>, 3> in;
};
constexpr std::array signs{
    Sign{'C', {{{"Click", "Cliquez"}, {"Tap", "Touchez"}, {"Press A", "Appuyez sur A"}}}},
    Sign{'c', {{{"click", "cliquez"}, {"tap", "touchez"}, {"press A", "appuyez sur A"}}}},
    Sign{'S', {{{"", "sur "}, {"", ""}, {"", ""}}}},  // French clicks on things, and touches them
    Sign{'k', {{{"clicks", "clics"}, {"taps", "appuis"}, {"clicks", "clics"}}}},
    Sign{'B',
         {{{"Esc or right click", "Échap ou clic droit"},
           {"Two fingers", "Deux doigts"},
           {"B", "B"}}}},
};

struct LevelName {
  std::string_view english;
  std::string_view french;
};
constexpr std::array level_names{
    LevelName{"First steps", "Premiers pas"},
    LevelName{"Two towers", "Les deux tours"},
    LevelName{"Pass it on", "Faites passer"},
    LevelName{"Off the back wall", "Par la bande"},
    LevelName{"Over the wall", "Par-dessus le mur"},
    LevelName{"Skittles", "Les quilles"},
    LevelName{"The pit", "La fosse"},
    LevelName{"Sentinels", "Les sentinelles"},
    LevelName{"The crown", "La couronne"},
    LevelName{"The fortress", "La forteresse"},
};

static_assert(
    [] {
      for (std::size_t i = 0; i < entries.size(); ++i)
        if (static_cast<std::size_t>(entries[i].text) != i) return false;
      return true;
    }(),
    "the table must list the texts in the order of the enumeration");

}  // namespace

Language language_of_locale(std::string_view locale) {
  return locale.starts_with("fr") ? Language::french : Language::english;
}

std::string Words::operator()(Text text, std::initializer_list<std::string_view> values) const {
  const InputDevice hand = voice_->hand;
  for (const ByHand& other : by_hand)
    if (other.hand == hand && other.text == text) {
      text = other.instead;
      break;
    }
  const std::string_view pattern =
      entries[static_cast<std::size_t>(text)].in[static_cast<std::size_t>(language())];
  std::string out;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (pattern[i] == '{') {
      const auto n = static_cast<std::size_t>(pattern[i + 1] - '0');
      if (n < values.size()) out += values.begin()[n];
      i += 2;
    } else if (pattern[i] == '[') {
      const char sign = pattern[i + 1];
      if (sign == '|' && hand != InputDevice::mouse) break;
      for (const Sign& known : signs)
        if (known.sign == sign)
          out += known.in[static_cast<std::size_t>(hand)][static_cast<std::size_t>(language())];
      i += 2;
    } else {
      out += pattern[i];
    }
  }
  return out;
}

std::string Words::number(int value) const {
  const std::string_view separator = language() == Language::french ? "\u202f" : ",";
  std::string digits = std::to_string(value);
  for (std::size_t at = digits.size(); at > 3 && digits[at - 4] != '-';) {
    at -= 3;
    digits.insert(at, separator);
  }
  return digits;
}

std::string Words::tenths(double value) const {
  const auto all = static_cast<int>(std::lround(value * 10));
  const int part = std::abs(all % 10);
  return (all < 0 ? "−" : "") + number(std::abs(all / 10)) +
         (language() == Language::french ? "," : ".") + std::to_string(part);
}

std::string Words::level_name(std::string_view name) const {
  if (name.empty()) return (*this)(Text::unnamed_level);
  for (const LevelName& known : level_names)
    if (language() == Language::french && known.english == name) return std::string(known.french);
  return std::string(name);
}

std::string Words::player(int player) const {
  const std::string& name = voice_->names[static_cast<std::size_t>(player)];
  return name.empty() ? (*this)(Text::player, {number(player + 1)}) : name;
}

}  // namespace app
