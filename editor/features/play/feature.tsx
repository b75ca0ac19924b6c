import type { Command } from '../../core/commands/index.ts';
import type { Editor } from '../../core/context/index.ts';
import { laterCover } from '../../core/panel/index.ts';
import { RATES } from '../../core/session/index.ts';
import type { Feature } from '../feature.ts';
import './play.css';

/** The level as a game. */
export const play: Feature = {
  name: 'play',
  screen: laterCover(
    ({ mode }) => mode === 'play',
    () => import('./PlayScreen.tsx').then(({ PlayScreen }) => PlayScreen),
    { mode: 'edit' },
  ),
  commands: playCommands,
};

/** Commands that start a playtest and set its speed. */
function playCommands({ session, settings, notices }: Editor): readonly Command[] {
  const changeRate = (by: number) => {
    const index = RATES.indexOf(session.getState().rate) + by;
    if (index >= 0 && index < RATES.length) session.setState({ rate: RATES[index] });
  };
  return [
    {
      id: 'play.start',
      title: 'Play from the start',
      group: 'Play',
      keys: ['Space'],
      pad: 'Start',
      run: () => session.setState({ mode: 'play', playFrom: 'start', isPlayingBack: false }),
    },
    {
      id: 'play.from-here',
      title: 'Play from the current tick',
      group: 'Play',
      keys: ['Shift+Space'],
      run: () => session.setState({ mode: 'play', playFrom: 'scrubbed', isPlayingBack: false }),
    },
    {
      id: 'play.slower',
      title: 'Play slower',
      group: 'Play',
      mode: 'both',
      keys: ['BracketLeft'],
      pad: 'Down',
      run: () => changeRate(-1),
    },
    {
      id: 'play.faster',
      title: 'Play faster',
      group: 'Play',
      mode: 'both',
      keys: ['BracketRight'],
      pad: 'Up',
      run: () => changeRate(1),
    },
    {
      id: 'play.show-run',
      title: "Show or hide the run's path while playing",
      group: 'Play',
      mode: 'both',
      keys: ['w'],
      run: () => {
        const runInPlay = !settings.getState().runInPlay;
        settings.setState({ runInPlay });
        const text = runInPlay ? "The run's path is shown while you play." : "The run's path is hidden while you play.";
        notices.show('info', text, { topic: 'runInPlay' });
      },
    },
    {
      id: 'play.sound',
      title: 'Turn sound on or off',
      group: 'Play',
      mode: 'both',
      keys: ['u'],
      run: () => {
        const sound = !settings.getState().sound;
        settings.setState({ sound });
        notices.show('info', sound ? 'Sound is on.' : 'Sound is off.', { topic: 'sound' });
      },
    },
  ];
}
