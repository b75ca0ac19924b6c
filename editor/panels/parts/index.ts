import './parts.css';

export { afterRest } from './after-rest.ts';
export { useCalmProof } from './calm-proof.ts';
export { Facts } from './Facts.tsx';
export { Progress } from './Progress.tsx';
export { useRestingProof } from './resting-proof.ts';
export { Section } from './Section.tsx';
export { Segments } from './Segments.tsx';
