/** Another way to be shown beside that of the run: an attempt, a candidate. Places at every tick. */
export interface Ghost {
  readonly id: string;
  readonly label: string;
  /** x, y in px, two entries a tick */
  readonly points: Float32Array;
  readonly look: 'attempt' | 'candidate' | 'slack';
}
