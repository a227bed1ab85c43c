// Eigen's decompositions of real matrices, compiled once, in decompositions.cpp: a source that instantiates one takes
// up to ten seconds more.
#pragma once

#include <Eigen/Eigenvalues>
#include <Eigen/SparseLU>

extern template class Eigen::EigenSolver<Eigen::MatrixXd>;
extern template class Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>;
extern template class Eigen::SparseLU<Eigen::SparseMatrix<double>>;
