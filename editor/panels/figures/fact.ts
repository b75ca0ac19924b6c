/** Something that is so, and when it is. */
export interface Fact {
  readonly label: string;
  readonly value: string;
  /** The tick it is about: the timeline goes there. */
  readonly tick?: number;
  readonly tone?: 'good' | 'bad' | 'warn';
}
