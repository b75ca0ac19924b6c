import { useEffect, useRef, useState } from 'react';

interface InlineNameProps {
  readonly label: string;
  readonly value: string;
  readonly longest: number;
  /** Enter, or another place was clicked; only with a text that differs. */
  readonly onDone: (name: string) => void;
  /** The field is to go: done or given up. */
  readonly onEnd: () => void;
}

/** A name that is edited in its row. */
export function InlineName({ label, value, longest, onDone, onEnd }: InlineNameProps) {
  const [text, setText] = useState(value);
  const input = useRef<HTMLInputElement>(null);
  // the tree had the focus, and is to have it again; leaving the field by Esc must not count as done
  const over = useRef(false);
  useEffect(() => {
    const tree = input.current?.closest<HTMLElement>('[role=tree]');
    // a menu that has just closed gives the focus back first
    const frame = requestAnimationFrame(() => {
      input.current?.focus();
      input.current?.select();
    });
    return () => {
      cancelAnimationFrame(frame);
      if (document.activeElement === null || document.activeElement === document.body) tree?.focus({ preventScroll: true });
    };
  }, []);
  const end = (keep: boolean) => {
    if (over.current) return;
    over.current = true;
    const name = text.trim();
    if (keep && name !== '' && name !== value) onDone(name);
    onEnd();
  };
  return (
    <input
      ref={input}
      className="field tree__name"
      aria-label={label}
      value={text}
      maxLength={longest}
      spellCheck={false}
      onChange={(event) => setText(event.target.value)}
      onBlur={() => end(true)}
      onClick={(event) => event.stopPropagation()}
      onDoubleClick={(event) => event.stopPropagation()}
      onContextMenu={(event) => event.stopPropagation()}
      onKeyDown={(event) => {
        event.stopPropagation();
        if (event.key === 'Enter') end(true);
        else if (event.key === 'Escape') end(false);
      }}
    />
  );
}
