import { COLOURS, type DrawnPart } from '../../canvas/index.ts';
import { type DeathMap, shelfOf } from '../../core/shelf/index.ts';
import type { Feature } from '../feature.ts';
import { DeathLegend } from './DeathLegend.tsx';
import { DeathTip } from './DeathTip.tsx';
import { DeathLayer } from './death-layer.ts';
import { followPlayLinks, takeLinkedPlay } from './follow-play-links.ts';
import { playsCommands } from './plays-commands.ts';

const drawn: DrawnPart<DeathMap | null> = {
  pictureOf({ session }, level) {
    const { store } = shelfOf(level);
    return () => (session.getState().layers.deaths ? store.getState().deaths : null);
  },
  draw: (scene, theme) => new DeathLayer(scene, COLOURS[theme]),
};

/** Recorded plays: opened, verified, shared, and where their players fail. */
export const plays: Feature = {
  name: 'plays',
  layers: [{ id: 'deaths', title: 'heat map of deaths', isShown: true }],
  canvas: { drawn, legend: DeathLegend, cards: DeathTip },
  commands: playsCommands,
  arrive(page) {
    const linked = takeLinkedPlay(page);
    return (editor) => followPlayLinks(editor, linked);
  },
};
