import './parts.css';

export { afterRest } from './after-rest.ts';
export { Facts } from './Facts.tsx';
export { Offer } from './Offer.tsx';
export { PlayButton } from './PlayButton.tsx';
export { Progress } from './Progress.tsx';
export { Section } from './Section.tsx';
export { Segments } from './Segments.tsx';
export { useDebouncedProof } from './use-debounced-proof.ts';
export { useThrottledProof } from './use-throttled-proof.ts';
