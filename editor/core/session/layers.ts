/** A layer over the level that can be shown and hidden. */
export interface LayerSwitch {
  /** Its name in `layers` of the session. */
  readonly id: string;
  /** In words, to follow `Show or hide the`. */
  readonly title: string;
  readonly keys?: readonly string[];
  /** Whether it is shown at first. */
  readonly isShown: boolean;
}

/** The layers of the canvas itself; features of the page add theirs. */
export const CANVAS_LAYERS: readonly LayerSwitch[] = [
  { id: 'ranges', title: 'range of the gun', isShown: true },
  { id: 'margins', title: 'hazard margins', isShown: true },
  { id: 'nearMisses', title: 'near misses', isShown: true },
  { id: 'slackFan', title: 'slack fan', isShown: true },
  { id: 'ghosts', title: 'ghosts of attempts and candidates', isShown: true },
  { id: 'notes', title: 'notes', isShown: true },
];
