// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The utility routines that a UMAT expects of its host, by the names that Fortran gives them. They
// are exported to loaded libraries (umat_host.exports) and act within the plug-in's process.
//
//   XIT                                    ends the analysis
//   STDB_ABQERR(LOP, STRING, INTV, REALV, CHARV)   1 note, −1 warning, −2 error, −3 error, stop
//   SINV(S, p, q, NDI, NSHR)               p = tr(S)/3, q = √(3/2)|S − p δ|
//   SPRINC(S, PS, LSTR, NDI, NSHR)         principal values, ascending
//   SPRIND(S, PS, AN, LSTR, NDI, NSHR)     with directions: AN(i, :) belongs to PS(i)
//   ROTSIG(S, R, S′, LSTR, NDI, NSHR)      S′ = R S Rᵗ
//   GETOUTDIR, GETJOBNAME, GETRANK, GETNUMCPUS, GETNUMTHREADS, GET_THREAD_ID,
//   MUTEXINIT, MUTEXLOCK, MUTEXUNLOCK      one process, one thread
//
// LSTR = 1: S is a stress, 2: a strain whose shear components are γ = 2 ε. Symmetric tensors hold
// NDI direct components, then NSHR of 12, 13, 23.

namespace triax::sim {

struct UmatExchange;

/// From now on the routines report into this exchange. (Calling it also keeps them in the program,
/// to which nothing else refers.)
void umat_host_serve(UmatExchange* exchange);

}  // namespace triax::sim
