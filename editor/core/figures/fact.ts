/** A labelled value. */
export interface Fact {
  readonly label: string;
  readonly value: string;
  /** The tick that it refers to: a click moves the timeline there. */
  readonly tick?: number;
  readonly tone?: 'good' | 'bad' | 'warn';
}
