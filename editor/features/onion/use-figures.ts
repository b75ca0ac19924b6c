import { useEffect, useState } from 'react';
import { useLevel } from '../../core/context/index.ts';
import { type Figures, figuresOf } from './figures.ts';

/** ms between two changes of the figures during a gesture: nobody reads faster, and each change costs layout and paint. */
const PACE = 100;

/** The figures of the shown run; while something is dragged, those of a moment ago. */
export function useFigures(isHeld: boolean): Figures {
  const { proof } = useLevel();
  const [figures, setFigures] = useState(() => figuresOf(proof.proof()));
  useEffect(() => {
    let timer: number | null = null;
    const show = () => {
      timer = null;
      setFigures(figuresOf(proof.proof()));
    };
    show();
    const stop = proof.store.subscribe(() => {
      if (isHeld) timer ??= window.setTimeout(show, PACE);
      else show();
    });
    return () => {
      stop();
      if (timer !== null) window.clearTimeout(timer);
    };
  }, [proof, isHeld]);
  return figures;
}
