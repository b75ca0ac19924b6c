import { TriangleAlert } from 'lucide-react';
import { useEffect, useState } from 'react';
import { useStore } from 'zustand';
import { useLevel } from '../core/context/index.ts';
import type { OpenedLevel } from '../core/files/index.ts';
import { Button } from '../core/ui/index.ts';

/** Asks before the page is left, since it alone has the change. */
function useQuestionOnLeaving(): void {
  useEffect(() => {
    const ask = (event: BeforeUnloadEvent) => event.preventDefault();
    window.addEventListener('beforeunload', ask);
    return () => window.removeEventListener('beforeunload', ask);
  }, []);
}

function Question({ opened }: { readonly opened: OpenedLevel }) {
  const [isTaking, setIsTaking] = useState(false);
  useQuestionOnLeaving();
  return (
    <aside className="heldbar" aria-label="Change that waits">
      <TriangleAlert size={16} />
      <p className="heldbar__text" role="alert">
        Another tab has this level open. Your change is only in this tab, and is not saved.
      </p>
      <Button
        hint="Save it here; the other tab becomes read-only"
        look="main"
        disabled={isTaking}
        onClick={() => {
          setIsTaking(true);
          opened.lock.takeOver();
        }}
      >
        {isTaking ? 'Taking over…' : 'Take over and save'}
      </Button>
      <Button
        hint="Show the level as the other tab has it; undo brings the change back"
        look="outlined"
        onClick={() => opened.dropHeld()}
      >
        Drop the change
      </Button>
    </aside>
  );
}

/** What to do with a change of a level that another tab writes. It is kept until the user has chosen. */
export function HeldBar() {
  const { opened } = useLevel();
  const isHolding = useStore(opened.holding);
  return isHolding ? <Question opened={opened} /> : null;
}
