import { useSession } from '../../core/context/index.ts';
import type { Feature } from '../feature.ts';
import { PlayView } from './PlayView.tsx';
import { playCommands } from './play-commands.ts';
import { ReplayView } from './ReplayView.tsx';

/** The playtest, or the replay of a play. */
function Screen() {
  const mode = useSession((state) => state.mode);
  const playFrom = useSession((state) => state.playFrom);
  if (mode !== 'play') return null;
  return typeof playFrom === 'string' ? <PlayView /> : <ReplayView replay={playFrom} />;
}

/** The level as a game. */
export const play: Feature = { name: 'play', screen: Screen, commands: playCommands };
