/** A path beside that of the run: an attempt, a candidate, a part of the slack fan, an attempt or play that is selected. */
export interface Ghost {
  readonly id: string;
  readonly label: string;
  /** x, y in px, two entries per tick */
  readonly points: Float32Array;
  readonly look: 'attempt' | 'candidate' | 'slack' | 'selected';
}
