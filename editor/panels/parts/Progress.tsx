interface ProgressProps {
  readonly label: string;
  readonly isRunning: boolean;
  /** 0 to 1; left out where it is not known how long it takes. */
  readonly share?: number;
}

/** How far something has come. It keeps its room when it is over: a control below must not move away from under a press. */
export function Progress({ label, isRunning, share }: ProgressProps) {
  // without a value it would move on, unseen
  return (
    <progress className={isRunning ? 'progress' : 'progress progress--over'} aria-label={label} value={isRunning ? share : 1} />
  );
}
