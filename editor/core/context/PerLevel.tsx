import { type ComponentType, Fragment, type ReactNode, useRef } from 'react';
import { useLevel } from './context.ts';

/**
 * A number that changes whenever another level is opened, whatever its file is called: a React key for state that belongs to
 * one level.
 */
export function useLevelKey(): number {
  const level = useLevel();
  const opening = useRef({ level, number: 0 });
  if (opening.current.level !== level) opening.current = { level, number: opening.current.number + 1 };
  return opening.current.number;
}

/** Resets its children with every level: scroll positions, folded parts, unfinished input. */
export function PerLevel({ children }: { readonly children: ReactNode }) {
  return <Fragment key={useLevelKey()}>{children}</Fragment>;
}

/** A component that is reset with every level. */
export const perLevel = (Part: ComponentType) => () => (
  <PerLevel>
    <Part />
  </PerLevel>
);
