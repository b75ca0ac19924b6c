import { accuracy } from './accuracy/feature.tsx';
import { alive } from './alive/feature.tsx';
import { attempts } from './attempts/feature.tsx';
import { compare } from './compare/feature.tsx';
import { conflicts } from './conflicts/feature.tsx';
import { effects } from './effects/feature.tsx';
import type { Feature } from './feature.ts';
import { history } from './history/feature.tsx';
import { inspector } from './inspector/feature.tsx';
import { kept } from './kept/feature.tsx';
import { leeway } from './leeway/feature.tsx';
import { levels } from './levels/feature.tsx';
import { lost } from './lost/feature.tsx';
import { mend } from './mend/feature.tsx';
import { onion } from './onion/feature.tsx';
import { outliner } from './outliner/feature.tsx';
import { pack } from './pack/feature.tsx';
import { places } from './places/feature.tsx';
import { play } from './play/feature.tsx';
import { plays } from './plays/feature.tsx';
import { problems } from './problems/feature.tsx';
import { runs } from './runs/feature.tsx';
import { share } from './share/feature.tsx';
import { solver } from './solver/feature.tsx';
import { tour } from './tour/feature.tsx';

export type { Feature, Panel } from './feature.ts';
// what the frame of the page says of a level
export { ruleLabel } from './inspector/index.ts';
export { useProblemCount } from './problems/index.ts';

/**
 * All features of the page, in the order in which their tabs, legends and commands stand. Where two draw at the same depth of the
 * canvas, the later one covers the earlier.
 */
export const FEATURES: readonly Feature[] = [
  pack,
  levels,
  history,
  outliner,
  runs,
  attempts,
  inspector,
  solver,
  effects,
  accuracy,
  problems,
  lost,
  leeway,
  plays,
  onion,
  compare,
  alive,
  mend,
  play,
  share,
  conflicts,
  kept,
  places,
  tour,
];
