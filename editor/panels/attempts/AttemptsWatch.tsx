import { useEffect, useMemo } from 'react';
import { useStore } from 'zustand';
import { useEditor, useLevel } from '../../context/index.ts';
import { shelfOf } from '../../shelf/index.ts';
import { createSelectedGhosts } from './selected-ghosts.ts';

/** Shows what is selected in the list of attempts on the canvas, whichever panel is in front. */
export function AttemptsWatch() {
  const { desk } = useEditor();
  const level = useLevel();
  const { store } = shelfOf(level);
  const attempts = useStore(level.attempts.store);
  const plays = useStore(store, (state) => state.plays);
  const selected = useStore(store, (state) => state.selected);
  const of = useStore(store, (state) => state.of);
  const ghosts = useMemo(() => createSelectedGhosts({ ghosts: level.ghosts, desk }), [level, desk]);
  useEffect(() => {
    const { level: now, terms } = level.proof.proof();
    const own = attempts.filter(({ number }) => selected.has(`attempt-${number}`));
    ghosts.show(
      { level: of?.level ?? now, terms },
      own,
      plays.filter(({ key }) => selected.has(key)),
    );
  }, [ghosts, level, of, attempts, plays, selected]);
  useEffect(() => () => ghosts.close(), [ghosts]);
  return null;
}
