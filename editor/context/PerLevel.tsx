import { Fragment, type ReactNode, useRef } from 'react';
import { useLevel } from './context.ts';

/** Another number for every level that is opened, whatever its file is called meanwhile: a key for what belongs to that one. */
export function useLevelKey(): number {
  const level = useLevel();
  const opening = useRef({ level, number: 0 });
  if (opening.current.level !== level) opening.current = { level, number: opening.current.number + 1 };
  return opening.current.number;
}

/** What begins anew with every level: where a list was scrolled to, what was folded, what was half typed. */
export function PerLevel({ children }: { readonly children: ReactNode }) {
  return <Fragment key={useLevelKey()}>{children}</Fragment>;
}
