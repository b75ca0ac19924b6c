import { joinHolds } from '../../../engine/index.ts';
import { COLOURS, type DrawnPart, unchanged } from '../../canvas/index.ts';
import { laterOnce, laterPart } from '../../core/panel/index.ts';
import type { Session } from '../../core/session/index.ts';
import { looksLike } from '../../timeline/index.ts';
import type { Feature } from '../feature.ts';
import './lost.css';
import { lossKey, lostOf } from './index.ts';
import { LostLayer } from './lost-layer.ts';
import { type LostPicture, lostPictureOf } from './lost-picture.ts';
import { LOST_KEY, lostSessionOf } from './watch-lost.ts';

const isShown = ({ layers }: Session) => layers.lost;

const fetch = () => import('./LostStates.tsx');
const LostReport = laterPart(() => fetch().then((there) => there.LostReport));
const LostLegend = laterOnce(isShown, () => fetch().then((there) => there.LostLegend));
const RunLossLabel = laterOnce(isShown, () => fetch().then((there) => there.RunLossLabel));
const LossMark = laterOnce(isShown, () => fetch().then((there) => there.LossMark));

const drawn: DrawnPart<LostPicture | null> = {
  pictureOf({ session }, level) {
    const { proof, attempts } = level;
    const found = lostOf(level);
    const shade = unchanged(
      () => {
        const { losing, losses } = found.getState();
        return [losing, losses, proof.proof().run, session.getState().layers.ghosts, attempts.store.getState()] as const;
      },
      ([losing, losses, , showsGhosts, own]) => {
        const paths = showsGhosts ? own : [];
        const keyed = paths.map(({ holds, accuracy, points }) => ({ key: lossKey(joinHolds(holds), accuracy), points }));
        return lostPictureOf({ losing, losses }, proof.proof(), keyed);
      },
    );
    return () => {
      const { layers, mode } = session.getState();
      return layers.lost && mode === 'edit' ? shade() : null;
    };
  },
  draw: (scene, theme) => new LostLayer(scene, COLOURS[theme]),
};

/** Where the level is already lost: the shade, and since when runs and attempts were. */
export const lost: Feature = {
  name: 'lost',
  layers: [{ id: 'lost', title: 'states that are already lost', keys: [LOST_KEY], isShown: false }],
  canvas: { drawn, labels: RunLossLabel, legend: LostLegend },
  timeline: {
    marks: LossMark,
    legend: {
      bars: [
        [looksLike('lost'), 'The run is already lost; this is proved.'],
        [looksLike('not-found'), 'No run was found from here on, which proves nothing.'],
      ],
    },
  },
  section: { panel: 'solver', content: LostReport },
  open: (editor, level) => lostSessionOf(editor, level).close,
};
